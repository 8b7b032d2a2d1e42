// Saves the picture, the field and the paths, and copies the question.

import type { Explorer } from "../explorer";
import { byId, onClick } from "./elements";
import type { Notice } from "./notice";
import type { PathLabels } from "./path_labels";
import { download, stem } from "../save/download";
import { csv, npy, ply } from "../save/field_files";
import { pathsObj } from "../save/path_files";
import { drawPicture } from "../save/picture";
import { commandLines, pythonLines, type AskedQuestion } from "../save/question_text";
import type { Scene } from "../scene/scene";

export class SavePanel {
  constructor(
    private readonly explorer: Explorer,
    private readonly scene: Scene,
    private readonly notice: Notice,
    private readonly labels: PathLabels,
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

  private async savePicture(): Promise<void> {
    const { mesh, field } = this.explorer;
    if (mesh) download(`${stem(mesh.name)}.png`, await drawPicture(this.scene, field, this.labels));
  }

  private saveField(ending: string, write: (distances: Float64Array) => BlobPart[]): void {
    const { mesh, exactField, isWaiting, summary, radius } = this.explorer;
    if (!mesh || !exactField) {
      this.notice.hint(
        isWaiting || summary ? "The exact field is still on its way." : "There is no field yet: click a point of the surface.");
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
    const { mesh, sources, radius, paths } = this.explorer;
    if (!mesh || !sources.length) {
      this.notice.hint("There is no question yet: click a point of the surface.");
      return;
    }
    const text = write({
      mesh: mesh.name.includes(".") ? mesh.name : mesh.digest,
      sources,
      radius,
      algorithm: this.algorithmName(),
      targets: paths.map((path) => path.target),
    });
    const box = byId("question-text");
    box.textContent = text;
    box.hidden = false;
    // Browsers let pages write to the clipboard on https and this machine only.
    navigator.clipboard?.writeText(text).then(
      () => this.notice.hint("Copied."),
      () => this.notice.hint("Select the text and copy it."),
    );
  }
}
