// The panel beside the picture: shows what is asked and answered, and passes on
// what the user chooses.

import type { Explorer } from "../explorer";
import { byId, onClick, term } from "./elements";
import { countText, formatCount, formatNumber } from "./format";
import { Legend } from "./legend";
import { Methods } from "./methods";
import type { Notice } from "./notice";
import type { PathLabels } from "./path_labels";
import { PathList } from "./path_list";
import { SavePanel } from "./save_panel";
import { ScaleBar } from "./scale_bar";
import type { Theme } from "./theme";
import type { Scene } from "../scene/scene";
import type { Connection } from "../service/connection";
import type { SurfaceMesh } from "../surface/mesh";
import { PREVIEW_WORDS } from "../surface/preview";

export type Tool = "source" | "path" | "curve" | "straight";

const RADIUS_STEPS = 1000;
const NO_FIELD = "There is no field yet: click a point of the surface.";

export class Panel {
  private readonly scale = new ScaleBar(byId("scale"));
  private readonly valueBox = byId<HTMLOutputElement>("value");
  private readonly radius = byId<HTMLInputElement>("radius");
  private readonly isolines = byId<HTMLInputElement>("isolines");
  private readonly cells = byId<HTMLInputElement>("cells");
  private readonly undoButton = byId<HTMLButtonElement>("undo");
  private readonly redoButton = byId<HTMLButtonElement>("redo");
  private readonly clearButton = byId<HTMLButtonElement>("clear");
  private readonly methods: Methods;
  private readonly legend: Legend;
  private readonly save: SavePanel;
  private readonly paths: PathList;

  constructor(
    private readonly explorer: Explorer,
    private readonly scene: Scene,
    private readonly connection: Connection,
    private readonly notice: Notice,
    private readonly theme: Theme,
    labels: PathLabels,
  ) {
    this.methods = new Methods((algorithm) => {
      explorer.fields.algorithm = algorithm;
      void explorer.askField();
    });
    this.legend = new Legend(explorer, scene, this.methods);
    this.save = new SavePanel(explorer, scene, notice, labels, this.legend, () => this.algorithmName());
    this.paths = new PathList((path) => explorer.removePath(path));
    onClick("theme", () => theme.toggle());
    onClick("help", () => this.help());
    onClick("undo", () => this.undo());
    onClick("redo", () => this.redo());
    onClick("clear", () => this.clear());
    onClick("sample", () => {
      const count = byId<HTMLInputElement>("sample-count");
      if (!count.reportValidity()) return;
      if (explorer.sources.length) void explorer.sample(count.valueAsNumber);
      else notice.hint(NO_FIELD);
    });
    onClick("compare", () => void this.compare());
    this.isolines.addEventListener("change", () => this.showIsolines());
    this.cells.addEventListener("change", () => explorer.fields.showCells(explorer.mesh, this.cells.checked));
    this.radius.addEventListener("input", () => {
      const share = this.radius.valueAsNumber / RADIUS_STEPS;
      const widest = this.widestRadius();
      this.setRadius(share < 1 && widest > 0 ? share * widest : Infinity);
    });
    for (const input of this.tools()) input.addEventListener("change", () => this.update());
  }

  get tool(): Tool {
    return this.tools().find((input) => input.checked)?.value as Tool;
  }

  choose(tool: Tool): void {
    for (const input of this.tools()) input.checked = input.value === tool;
    this.update();
  }

  async showCapabilities(): Promise<void> {
    this.methods.show(await this.connection.capabilities.getCapabilities({}));
    this.legend.update();
  }

  show(mesh: SurfaceMesh): void {
    byId("mesh-name").textContent = mesh.name;
    byId("mesh-name").title = mesh.digest;
    byId("questions").hidden = false;
    document.title = `${mesh.name} - geodesic`;
  }

  /** Chooses what comes next: a source, or paths from those there are. */
  chooseNext(): void {
    this.choose(this.explorer.sources.length ? "path" : "source");
  }

  update(): void {
    const { field, fields, sources, summary, paths, samples } = this.explorer;
    this.showSize();
    byId("source-count").textContent = countText(sources.length, "source");
    byId("next-step").textContent = this.nextStep();
    byId("cells-choice").hidden = sources.length < 2;
    this.cells.checked = fields.showsCells;
    this.undoButton.disabled = !this.explorer.canUndo;
    this.redoButton.disabled = !this.explorer.canRedo;
    this.clearButton.disabled = this.explorer.isEmpty;
    if (field?.painted !== "difference") byId("difference").replaceChildren();
    this.scale.show(field?.scaleEnd ?? 0);
    const figures: [string, string][] = [];
    if (field?.isPreview) {
      figures.push([farthest(this.explorer.radius ?? Infinity), `≈ ${formatNumber(field.largest, 4)}`]);
      figures.push(["for now", PREVIEW_WORDS + (fields.isWaiting ? "; the exact field is on its way" : "")]);
    }
    if (field && summary) {
      figures.push([farthest(summary.settledRadius), formatNumber(field.largest, 10)]);
      figures.push(["solved in", `${formatNumber(1000 * summary.solveSeconds, 3)} ms`]);
      if (samples.length) figures.push(["samples", formatCount(samples.length)]);
    }
    showTerms(byId("figures"), figures);
    this.paths.show(paths);
    this.showRadius();
    this.legend.update();
    this.save.update();
  }

  /** Where the cursor is, from the left and top of the window. */
  pointer(at: { x: number; y: number }): void {
    const stage = byId("stage").getBoundingClientRect();
    this.valueBox.style.setProperty("--x", `${at.x - stage.left}px`);
    this.valueBox.style.setProperty("--y", `${at.y - stage.top}px`);
  }

  value(distance: number | undefined, exact: boolean): void {
    this.valueBox.hidden = distance === undefined;
    this.scale.point(this.explorer.field?.painted === "distances" ? distance : undefined);
    if (distance === undefined) return;
    this.valueBox.textContent =
      distance === Infinity ? "not reached" : exact ? formatNumber(distance, 8) : `≈ ${formatNumber(distance, 4)}`;
    this.valueBox.dataset.exact = String(exact);
  }

  setRadius(radius: number): void {
    const { field, summary } = this.explorer;
    // Beyond the farthest of all there is nothing, beyond the farthest within a radius there is.
    const isAll = summary?.settledRadius === Infinity && radius >= (field?.largest ?? 0);
    this.explorer.setRadius(isAll || radius === Infinity ? undefined : Math.max(radius, 0));
  }

  clear(): void {
    this.explorer.clear();
    this.choose("source");
  }

  undo(): void {
    this.explorer.undo();
    this.chooseAgain();
  }

  redo(): void {
    this.explorer.redo();
    this.chooseAgain();
  }

  toggleIsolines(): void {
    this.isolines.checked = !this.isolines.checked;
    this.showIsolines();
  }

  toggleTheme(): void {
    this.theme.toggle();
  }

  help(): void {
    byId<HTMLDialogElement>("help-dialog").showModal();
  }

  // Who draws lines straight on may draw another one from a source that is there.
  private chooseAgain(): void {
    if (this.tool === "straight" && this.explorer.sources.length) this.update();
    else this.chooseNext();
  }

  private async compare(): Promise<void> {
    if (!this.explorer.exactField) {
      this.notice.hint(this.explorer.fields.isWaiting ? "The exact field is still on its way." : NO_FIELD);
      return;
    }
    const algorithm = this.methods.against;
    byId("difference").replaceChildren(term("dt", "Comparing…"));
    const difference = await this.explorer.compare(algorithm, this.methods.isApproximate(algorithm));
    if (!difference) {
      byId("difference").replaceChildren();
      return;
    }
    showTerms(byId("difference"), [
      ["largest difference", formatNumber(difference.largest, 3)],
      ["mean, relative", formatNumber(difference.meanRelative, 3)],
    ]);
  }

  private showIsolines(): void {
    this.scene.material.uniforms.showLines.value = this.isolines.checked;
    this.legend.update();
    this.scene.redrawSurface();
  }

  private showSize(): void {
    const { mesh } = this.explorer;
    if (!mesh) return;
    const faces = countText(mesh.faceCount, "face");
    const coarse = mesh.coarse?.index ? formatCount(mesh.coarse.index.count / 3) : undefined;
    const when = this.scene.mayBeWhole(mesh) ? " while it moves" : "";
    byId("mesh-size").textContent = coarse ? `${faces}, ${coarse} drawn${when}` : faces;
    byId("mesh-size").title = coarse ? "Drawn with fewer faces over the same vertices. All answers are the whole mesh's." : "";
  }

  private showRadius(): void {
    const { radius } = this.explorer;
    byId("radius-value").textContent = radius === undefined ? "all" : formatNumber(radius, 4);
    const share = radius ? radius / this.widestRadius() : 0;
    // The last step is for all, and can be gone to from the one before.
    this.radius.value = String(radius === undefined ? RADIUS_STEPS : Math.min(Math.round(share * RADIUS_STEPS), RADIUS_STEPS - 1));
  }

  /** What the length of the slider stands for: farther away nothing is known. */
  private widestRadius(): number {
    const { field, radius } = this.explorer;
    return Math.max(field?.largest ?? 0, radius ?? 0);
  }

  private nextStep(): string {
    if (this.tool === "curve") return "Drag on the surface: every point of the curve is a source.";
    if (!this.explorer.sources.length) return "Click a point of the surface.";
    if (this.tool === "straight") {
      return this.explorer.straightLength === undefined
        ? "Lines are as long as the slider says, or as the farthest distance: there is no such length yet."
        : "Drag from a source's dot: the line runs straight on in that direction. Click to move the source.";
    }
    if (this.tool === "source") return "Click to move the source; Shift and click for one more.";
    return "Move: the shortest path follows. Click to keep it; Shift and click for one more source.";
  }

  /** As the command spells it; nothing for the server's choice. */
  private algorithmName(): string | undefined {
    const { algorithm } = this.explorer.fields;
    return algorithm === 0 ? undefined : this.methods.nameOf(algorithm);
  }

  private tools(): HTMLInputElement[] {
    return [...document.querySelectorAll<HTMLInputElement>('input[name="tool"]')];
  }
}

/** What the largest distance is of, where those up to `radius` are known. */
function farthest(radius: number): string {
  return radius === Infinity ? "farthest" : `farthest up to ${formatNumber(radius, 4)}`;
}

function showTerms(list: HTMLElement, terms: [string, string][]): void {
  list.replaceChildren(...terms.flatMap(([name, value]) => [term("dt", name), term("dd", value)]));
}
