// Opens a mesh: a file that is dropped or chosen, or one that the server has.

import { countText } from "./format";
import { byId, onClick } from "./elements";
import type { Notice } from "./notice";
import type { Recovery } from "./recovery";
import type { Connection } from "../service/connection";
import { DRAWN_WHOLE } from "../scene/detail";
import { decimateMesh } from "../service/decimate_mesh";
import { readMesh } from "../service/read_mesh";
import { formatOf, uploadMesh } from "../service/upload";
import { SurfaceMesh } from "../surface/mesh";

export class MeshChooser {
  private readonly input = byId<HTMLInputElement>("file");
  private readonly select = byId<HTMLSelectElement>("meshes");
  private readonly names = new Map<string, string>();
  private file: File | undefined;
  private shown = "";
  private opening = new AbortController();

  constructor(
    private readonly connection: Connection,
    private readonly notice: Notice,
    private readonly recovery: Recovery,
    private readonly coarseFaces: number,
    private readonly opened: (mesh: SurfaceMesh) => void,
    private readonly decimated: (mesh: SurfaceMesh, indices: Uint32Array | undefined) => void,
  ) {
    onClick("open", () => this.input.click());
    onClick("welcome-open", () => this.input.click());
    this.input.addEventListener("change", () => {
      if (this.input.files?.[0]) this.openFile(this.input.files[0]);
      this.input.value = "";
    });
    this.select.addEventListener("change", () => {
      if (!this.select.value) {
        this.select.value = this.shown;
        return;
      }
      this.file = undefined;
      void this.recovery.attempt(() => this.openDigest(this.select.value));
    });
    this.listenToDrops(byId("stage"));
  }

  openFile(file: File): void {
    void this.recovery.attempt(async () => {
      formatOf(file.name);
      this.notice.clear();
      this.file = file;
      const digest = await this.upload(file);
      this.names.set(digest, file.name);
      await this.openDigest(digest);
      // A list that fails is asked for again by itself: the mesh is shown by now.
      void this.recovery.attempt(() => this.list());
    });
  }

  /** Uploads the file again that is shown; nothing if it came from the server. */
  uploadAgain(): (() => Promise<void>) | undefined {
    const { file } = this;
    return file && (() => this.upload(file).then(() => this.notice.done()));
  }

  async openDigest(digest: string): Promise<void> {
    const abort = this.begin();
    const show = (share: number) => this.notice.busy("Reading the mesh", share);
    // The server works on it while the mesh comes. Without it all is drawn.
    let coarse: Promise<Uint32Array | undefined> | undefined;
    const counted = (faceCount: number) => {
      if (faceCount <= DRAWN_WHOLE) return;
      coarse = decimateMesh(this.connection, digest, this.coarseFaces, abort.signal).catch(() => undefined);
    };
    const arrays = await readMesh(this.connection, digest, counted, show, abort.signal);
    const name = this.names.get(digest) ?? digest.slice(0, 8);
    this.notice.busy("Preparing the picture");
    // The line above is on the screen before the work begins.
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    const mesh = new SurfaceMesh(arrays, digest, name);
    mesh.awaitsCoarse = coarse !== undefined;
    this.opened(mesh);
    void coarse?.then((indices) => this.decimated(mesh, indices));
    this.notice.done();
    byId("welcome").hidden = true;
    this.shown = this.select.value = digest;
  }

  async list(): Promise<void> {
    const { meshes } = await this.connection.meshes.listMeshes({ pageSize: 1000 });
    const choices = meshes.map((mesh) => {
      const name = this.names.get(mesh.digest) ?? mesh.digest.slice(0, 8);
      return { digest: mesh.digest, text: `${name} (${countText(Number(mesh.faceCount), "face")})` };
    });
    this.select.replaceChildren(
      new Option(choices.length ? "on the server…" : "no mesh on the server", ""),
      ...choices.map(({ digest, text }) => new Option(text, digest)),
    );
    this.select.value = this.shown;
    byId("welcome-meshes").replaceChildren(
      ...choices.slice(0, 12).map(({ digest, text }) => {
        const button = document.createElement("button");
        button.textContent = text;
        button.addEventListener("click", () => void this.recovery.attempt(() => this.openDigest(digest)));
        return button;
      }),
    );
  }

  private upload(file: File): Promise<string> {
    const abort = this.begin();
    const show = (share: number) =>
      this.notice.busy(share < 1 ? `Sending ${file.name}` : `The server reads ${file.name}`, share < 1 ? share : undefined);
    show(0);
    return uploadMesh(this.connection, file, show, abort.signal);
  }

  // Stops what is being opened.
  private begin(): AbortController {
    this.opening.abort();
    return (this.opening = new AbortController());
  }

  private listenToDrops(stage: HTMLElement): void {
    const body = document.body;
    body.addEventListener("dragover", (event) => {
      event.preventDefault();
      stage.classList.add("over");
    });
    body.addEventListener("dragleave", () => stage.classList.remove("over"));
    body.addEventListener("drop", (event) => {
      event.preventDefault();
      stage.classList.remove("over");
      const file = event.dataTransfer?.files[0];
      if (file) this.openFile(file);
    });
  }
}
