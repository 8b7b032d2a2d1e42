// Saves the picture, the field and the paths, and copies the question.

import type { Explorer } from "../explorer";
import { byId, onClick } from "./elements";
import type { Legend } from "./legend";
import type { Notice } from "./notice";
import type { PathLabels } from "./path_labels";
import { download, stem } from "../save/download";
import { csv, npy, ply } from "../save/field_files";
import { pathsObj } from "../save/path_files";
import { drawPicture } from "../save/picture";
import { commandLines, pythonLines, type AskedQuestion } from "../save/question_text";
import type { Scene } from "../scene/scene";

export class SavePanel {
  private readonly text = byId("question-text");
  private write: ((question: AskedQuestion) => string) | undefined;

  constructor(
    private readonly explorer: Explorer,
    private readonly scene: Scene,
    private readonly notice: Notice,
    private readonly labels: PathLabels,
    private readonly legend: Legend,
    private readonly algorithmName: () => string | undefined,
  ) {
    onClick("save-picture", () => void this.savePicture());
    onClick("save-npy", () => this.saveField("npy", npy));
    onClick("save-csv", () => this.saveField("csv", csv));
    onClick("save-ply", () => this.saveField("ply", (d) => (explorer.mesh ? ply(explorer.mesh.arrays, d) : [])));
    onClick("save-paths", () => this.savePaths());
    onClick("copy-command", () => this.copy(commandLines));
    onClick("copy-python", () => this.copy(pythonLines));
  }

  /** The question is another one: so is its text, where it is shown. */
  update(): void {
    const question = this.question();
    this.text.hidden = !question || !this.write;
    if (question && this.write) this.text.textContent = this.write(question);
  }

  private async savePicture(): Promise<void> {
    const { mesh, field } = this.explorer;
    if (mesh) download(`${stem(mesh.name)}.png`, await drawPicture(this.scene, field, this.labels, this.legend));
  }

  private saveField(ending: string, write: (distances: Float64Array) => BlobPart[]): void {
    const { mesh, exactField, fields, summary, radius } = this.explorer;
    if (!mesh || !exactField) {
      this.notice.hint(
        fields.isWaiting || summary ? "The exact field is still on its way." : "There is no field yet: click a point of the surface.");
      return;
    }
    const limit = radius ?? Infinity;
    const distances = exactField.distances.map((d) => (d <= limit ? d : Infinity));
    download(`${stem(mesh.name)}-field.${ending}`, write(distances));
  }

  private savePaths(): void {
    const { mesh, paths } = this.explorer;
    if (!mesh || !paths.length) {
      this.notice.hint("There is no path yet: click where one should end.");
      return;
    }
    download(`${stem(mesh.name)}-paths.obj`, pathsObj(paths));
  }

  private copy(write: (question: AskedQuestion) => string): void {
    const question = this.question();
    if (!question) {
      this.notice.hint("There is no question yet: click a point of the surface.");
      return;
    }
    this.write = write;
    this.update();
    const toFill = question.server ? " For PORT put the one of the server's --listen." : "";
    // Browsers let pages write to the clipboard on https and this machine only.
    navigator.clipboard?.writeText(write(question)).then(
      () => this.notice.hint(`Copied.${toFill}`),
      () => this.notice.hint(`Select the text and copy it.${toFill}`),
    );
  }

  /** What is asked; nothing while there is neither a source nor a path. */
  private question(): AskedQuestion | undefined {
    const { mesh, sources, radius, paths } = this.explorer;
    if (!mesh || (!sources.length && !paths.length)) return undefined;
    return {
      mesh: mesh.isFile ? mesh.name : mesh.digest,
      server: mesh.isFile ? undefined : `${location.hostname}:PORT`,
      sources,
      radius,
      algorithm: this.algorithmName(),
      lines: paths.map((path) => path.question),
    };
  }
}
