// Opens a mesh: a file that is dropped or chosen, or one that the server has.

import { countText } from "./format";
import { byId, onClick } from "./elements";
import type { Notice } from "./notice";
import type { Recovery } from "./recovery";
import { joiningWords, Seams } from "./seams";
import { about, type Connection } from "../service/connection";
import { DRAWN_WHOLE } from "../scene/detail";
import { askRestoring } from "../service/ask_restoring";
import { readMesh } from "../service/read_mesh";
import { ENDINGS, formatOf, uploadMesh, type Joining } from "../service/upload";
import { SurfaceMesh } from "../surface/mesh";
import { simplify } from "../surface/simplify";

/** A file that was opened here, and how it was read. */
interface Opened {
  file: File;
  joining: Joining;
}

/** As files are read at first. */
const WITHIN_ROUNDING: Joining = { keepSeams: false };

export class MeshChooser {
  private readonly input = byId<HTMLInputElement>("file");
  private readonly select = byId<HTMLSelectElement>("meshes");
  /** Files that were opened here, by the digest of their mesh. */
  private readonly files = new Map<string, Opened>();
  /** Those of them that are on their way again. */
  private readonly restored = new Map<string, Promise<void>>();
  private readonly seams = new Seams((joining) => this.readAnew(joining));
  private shown = "";
  private opening = new AbortController();
  private restoring = new AbortController();

  constructor(
    private readonly connection: Connection,
    private readonly notice: Notice,
    private readonly recovery: Recovery,
    private readonly coarseFaces: number,
    private readonly opened: (mesh: SurfaceMesh) => void,
    private readonly simplified: (mesh: SurfaceMesh, indices: Uint32Array | undefined) => void,
  ) {
    this.input.accept = [...ENDINGS, ".gz"].join(",");
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
    const opened = this.files.get(digest);
    if (!opened) return false;
    const restored = this.restored.get(digest) ?? this.sendAgain(digest, opened).finally(() => this.restored.delete(digest));
    this.restored.set(digest, restored);
    await restored;
    return true;
  }

  private async sendAgain(digest: string, opened: Opened): Promise<void> {
    this.restoring = new AbortController();
    const sent = await this.upload(opened, this.restoring.signal, digest);
    this.notice.done();
    if (sent !== digest) throw new Error(`The server has lost this mesh, and ${opened.file.name} holds another one by now.`);
  }

  private openFiles(files: FileList | null): void {
    const [file, ...others] = files ?? [];
    if (!file) return;
    void this.recovery.attempt(async () => {
      // A file that is no mesh leaves alone what is being opened.
      formatOf(file.name);
      this.openFile({ file, joining: WITHIN_ROUNDING }, () => {
        if (others.length) this.notice.hint(`One mesh at a time is shown: ${file.name}.`);
      });
    });
  }

  private openFile(opened: Opened, shown: (before: string) => void): void {
    this.open(async (signal) => {
      this.notice.clear();
      const digest = await this.upload(opened, signal);
      this.files.set(digest, opened);
      const before = this.shown;
      await this.read(digest, signal);
      shown(before);
      // A list that fails is asked for again by itself: the mesh is shown by now.
      void this.recovery.attempt(() => this.list());
    }, opened.file.name);
  }

  // Sends the file of the mesh that is shown, to be joined in another way.
  private readAnew(joining: Joining): void {
    const opened = this.files.get(this.shown);
    if (!opened) return;
    this.openFile({ ...opened, joining }, (before) => {
      this.notice.hint(before === this.shown
        ? "It is the same mesh: this joins no other edges."
        : "This is another mesh. Back, in the browser, shows the one before with its sources and paths.", 8000);
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
    const [arrays, { mesh: described }] = await Promise.all([
      readMesh(this.connection, digest, show, signal),
      this.connection.meshes.getMesh({ digest }, about(digest, signal)),
    ]);
    this.notice.busy("Preparing the picture");
    // The line above is on the screen before the work begins.
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    const mesh = new SurfaceMesh(arrays, digest, this.nameOf(digest));
    const opened = this.files.get(digest);
    mesh.isFile = opened !== undefined && !joiningWords(opened.joining);
    mesh.awaitsCoarse = mesh.faceCount > DRAWN_WHOLE;
    this.restoring.abort();
    this.notice.clear();
    this.opened(mesh);
    this.seams.show(described?.notes ?? [], opened?.joining);
    if (mesh.awaitsCoarse) void this.simplify(mesh, signal);
    if (!mesh.hasArea) this.notice.error(`${mesh.name}: no face has an area, so there is nothing to see.`);
    byId("welcome").hidden = true;
    this.shown = this.select.value = digest;
  }

  // Meanwhile, and if it fails, all is drawn.
  private async simplify(mesh: SurfaceMesh, signal: AbortSignal): Promise<void> {
    this.simplified(mesh, await simplify(mesh, this.coarseFaces, signal).catch(() => undefined));
  }

  async list(): Promise<void> {
    const { meshes } = await this.connection.meshes.listMeshes({ pageSize: 1000 });
    const choices = meshes.map((mesh) => {
      const opened = this.files.get(mesh.digest);
      const notes = [countText(Number(mesh.faceCount), "face"), opened ? joiningWords(opened.joining) : ""].filter(Boolean);
      return { digest: mesh.digest, text: `${this.nameOf(mesh.digest)} (${notes.join(", ")})` };
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
    return this.files.get(digest)?.file.name ?? digest.slice(0, 8);
  }

  private upload({ file, joining }: Opened, signal: AbortSignal, digest?: string): Promise<string> {
    const show = (share: number) =>
      this.notice.busy(share < 1 ? `Sending ${file.name}` : `The server reads ${file.name}`, share < 1 ? share : undefined);
    show(0);
    return uploadMesh(this.connection, file, joining, show, signal, digest);
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
