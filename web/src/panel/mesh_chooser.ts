// Opens a mesh: a file that is dropped or chosen, or one that the server has.

import { countText } from "./format";
import { byId, onClick } from "./elements";
import type { Notice } from "./notice";
import type { Recovery } from "./recovery";
import type { Connection } from "../service/connection";
import { DRAWN_WHOLE } from "../scene/detail";
import { askRestoring } from "../service/ask_restoring";
import { decimateMesh } from "../service/decimate_mesh";
import { readMesh } from "../service/read_mesh";
import { formatOf, uploadMesh } from "../service/upload";
import { SurfaceMesh } from "../surface/mesh";

export class MeshChooser {
  private readonly input = byId<HTMLInputElement>("file");
  private readonly select = byId<HTMLSelectElement>("meshes");
  /** Files that were opened here, by the digest of their mesh. */
  private readonly files = new Map<string, File>();
  /** Those of them that are on their way again. */
  private readonly restored = new Map<string, Promise<void>>();
  private shown = "";
  private opening = new AbortController();
  private restoring = new AbortController();

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
      this.openFiles(this.input.files);
      this.input.value = "";
    });
    this.select.addEventListener("change", () => {
      if (!this.select.value) {
        this.select.value = this.shown;
        return;
      }
      this.openDigest(this.select.value);
    });
    this.listenToDrops(byId("stage"));
  }

  openDigest(digest: string): void {
    this.open((signal) => askRestoring(() => this.read(digest, signal), () => this.restore(digest)));
  }

  /**
   * Sends the file of a mesh again that the server has lost; whether the page has
   * it. It is sent once for all questions that miss the mesh at the same time.
   */
  async restore(digest: string): Promise<boolean> {
    const file = this.files.get(digest);
    if (!file) return false;
    const restored = this.restored.get(digest) ?? this.sendAgain(digest, file).finally(() => this.restored.delete(digest));
    this.restored.set(digest, restored);
    await restored;
    return true;
  }

  private async sendAgain(digest: string, file: File): Promise<void> {
    this.restoring = new AbortController();
    const sent = await this.upload(file, this.restoring.signal);
    this.notice.done();
    if (sent !== digest) throw new Error(`The server has lost this mesh, and ${file.name} holds another one by now.`);
  }

  private openFiles(files: FileList | null): void {
    const [file, ...others] = files ?? [];
    if (!file) return;
    void this.recovery.attempt(async () => {
      // A file that is no mesh leaves alone what is being opened.
      formatOf(file.name);
      this.open(async (signal) => {
        this.notice.clear();
        const digest = await this.upload(file, signal);
        this.files.set(digest, file);
        await this.read(digest, signal);
        if (others.length) this.notice.hint(`One mesh at a time is shown: ${file.name}.`);
        // A list that fails is asked for again by itself: the mesh is shown by now.
        void this.recovery.attempt(() => this.list());
      }, file.name);
    });
  }

  // Stops what is being opened, and opens a mesh, until another is wanted.
  private open(work: (signal: AbortSignal) => Promise<void>, name?: string): void {
    this.opening.abort();
    const { signal } = (this.opening = new AbortController());
    void this.recovery.attempt(async () => {
      if (!signal.aborted) await work(signal);
    }, name);
  }

  private async read(digest: string, signal: AbortSignal): Promise<void> {
    const show = (share: number) => this.notice.busy("Reading the mesh", share);
    // The server works on it while the mesh comes. Without it all is drawn.
    let coarse: Promise<Uint32Array | undefined> | undefined;
    const counted = (faceCount: number) => {
      if (faceCount <= DRAWN_WHOLE) return;
      coarse = decimateMesh(this.connection, digest, this.coarseFaces, signal).catch(() => undefined);
    };
    const arrays = await readMesh(this.connection, digest, counted, show, signal);
    this.notice.busy("Preparing the picture");
    // The line above is on the screen before the work begins.
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    const mesh = new SurfaceMesh(arrays, digest, this.nameOf(digest));
    mesh.awaitsCoarse = coarse !== undefined;
    this.restoring.abort();
    this.notice.clear();
    this.opened(mesh);
    void coarse?.then((indices) => this.decimated(mesh, indices));
    if (!mesh.hasArea) this.notice.error(`${mesh.name}: no face has an area, so there is nothing to see.`);
    byId("welcome").hidden = true;
    this.shown = this.select.value = digest;
  }

  async list(): Promise<void> {
    const { meshes } = await this.connection.meshes.listMeshes({ pageSize: 1000 });
    const choices = meshes.map((mesh) => {
      return { digest: mesh.digest, text: `${this.nameOf(mesh.digest)} (${countText(Number(mesh.faceCount), "face")})` };
    });
    this.select.replaceChildren(
      new Option(choices.length ? "on the server…" : "no mesh yet", ""),
      ...choices.map(({ digest, text }) => new Option(text, digest)),
    );
    this.select.value = this.shown;
    byId("welcome-meshes").replaceChildren(
      ...choices.slice(0, 12).map(({ digest, text }) => {
        const button = document.createElement("button");
        button.textContent = text;
        button.addEventListener("click", () => this.openDigest(digest));
        return button;
      }),
    );
  }

  private nameOf(digest: string): string {
    return this.files.get(digest)?.name ?? digest.slice(0, 8);
  }

  private upload(file: File, signal: AbortSignal): Promise<string> {
    const show = (share: number) =>
      this.notice.busy(share < 1 ? `Sending ${file.name}` : `The server reads ${file.name}`, share < 1 ? share : undefined);
    show(0);
    return uploadMesh(this.connection, file, show, signal);
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
      this.openFiles(event.dataTransfer?.files ?? null);
    });
  }
}
