// Asks for the field of the sources and draws it as it comes: distances, cells, or
// how far those of another algorithm are from it.

import { Vector3 } from "three";
import { Algorithm } from "../generated/geodesic/v1/query_pb";
import type { Placed } from "./placed";
import { FieldView } from "./scene/field_view";
import { onScreen } from "./scene/marks";
import type { Scene } from "./scene/scene";
import type { Asking } from "./service/asking";
import { NewestOnly } from "./service/newest_only";
import { askCells, askDistances, askField, type FieldQuestion, type FieldSummary } from "./service/questions";
import { differenceOf, type Difference } from "./surface/difference";
import type { SurfaceMesh } from "./surface/mesh";
import type { Source } from "./surface/place";
import { PREVIEW_TOLERANCE, takesPreview } from "./surface/preview";

/** The exact field is asked for when what comes first has been swept over, or so much later. */
const LONGEST_SWEEP_MS = 1500;

/** Fields are worth waiting for, even if the source has moved on. */
const FIELD_PATIENCE_MS = 2000;

export interface FieldEvents {
  /** The field, or what is known of it, is another one now. */
  changed(): void;
  /** It has other colours. */
  repainted(): void;
  /** It gives way to another one: so does what is shown of it. */
  left(): void;
}

export class Fields {
  shown: FieldView | undefined;
  summary: FieldSummary | undefined;
  algorithm = Algorithm.UNSPECIFIED;
  /** The algorithm whose field the difference is from. */
  against = Algorithm.UNSPECIFIED;
  /** Whose distances it has, or will have. */
  sources: readonly Source[] = [];

  /** Whether cells are wanted where there are several sources. */
  private wantsCells = false;
  /** Up to where distances are there, or on their way. */
  private reach = Infinity;
  private readonly dragged = new NewestOnly(FIELD_PATIENCE_MS);
  private asked = new AbortController();
  private waiting = false;
  private swept: (() => void) | undefined;
  private readonly still = matchMedia("(prefers-reduced-motion: reduce)");

  /** `placed` is what there is on the mesh at the time. */
  constructor(
    private readonly scene: Scene,
    private readonly asking: Asking,
    private readonly placed: () => Placed,
    private readonly events: FieldEvents,
  ) {
    scene.onFrame = (now) => {
      const moved = this.shown?.advance(now, this.still.matches) ?? false;
      if (this.shown?.hasSwept) this.swept?.();
      document.documentElement.dataset.sweep = this.shown?.hasArrived ? "done" : this.shown?.hasSwept ? "preview" : "";
      return moved;
    };
    scene.isWaiting = () => this.waiting && !this.swept;
    // Until the whole field is there and swept, or could not be had.
    scene.isBusy = () => this.waiting || (this.summary !== undefined && this.shown?.hasArrived === false);
  }

  /** Whether an exact field is on its way. */
  get isWaiting(): boolean {
    return this.waiting;
  }

  /** Whether distances up to this radius are there, or on their way. */
  reaches(radius: number | undefined): boolean {
    return (radius ?? Infinity) <= this.reach;
  }

  /** Of what is asked about the field. */
  get signal(): AbortSignal {
    return this.asked.signal;
  }

  question(mesh: SurfaceMesh): FieldQuestion {
    const { sources, radius } = this.placed();
    return { digest: mesh.digest, sources, algorithm: this.algorithm, radius };
  }

  takeAway(mesh: SurfaceMesh | undefined): void {
    this.asked.abort();
    this.dragged.stop();
    this.events.left();
    this.shown = undefined;
    this.sources = [];
    this.summary = undefined;
    this.reach = Infinity;
    this.waiting = false;
    if (mesh) new FieldView(mesh, this.scene.material, new Vector3(), true);
  }

  /** Asks for the field of the sources, also if it is there: the radius or the method may be another. */
  async ask(mesh: SurfaceMesh): Promise<void> {
    const { sources } = this.placed();
    if (!sources.length) return;
    this.asked.abort();
    this.dragged.stop();
    this.events.left();
    const abort = (this.asked = new AbortController());
    const wasBare = !this.shown;
    const field = this.begin(mesh, sources);
    document.documentElement.dataset.sweep = "";
    this.summary = undefined;
    this.waiting = true;
    this.events.changed();
    if (wasBare) this.scene.redraw();
    else this.scene.redrawSurface();
    const question = this.newQuestion(mesh);
    try {
      // Not both at once: they would share the server's processors.
      if (takesPreview(mesh, question)) await this.preview(question, field, abort.signal);
      const summary = await this.asking.answerTo(mesh, () => askField(this.asking.connection, question, (part) => {
        field.add(part.vertices, part.distances);
        if (!field.isPreview) this.scene.redrawSurface();
      }, abort.signal));
      if (abort.signal.aborted) return;
      this.answer(summary, question);
      field.finish();
      if (this.showsCells) void this.paintCells(mesh, field);
    } catch (error) {
      this.asking.report(error, () => {
        if (abort === this.asked && !abort.signal.aborted) void this.ask(mesh);
      });
    } finally {
      if (abort === this.asked) this.waiting = false;
      this.events.changed();
      this.scene.redrawSurface();
    }
  }

  /** Lets the field follow a source while it is dragged. */
  follow(mesh: SurfaceMesh): void {
    this.asked.abort();
    this.asked = new AbortController();
    this.waiting = false;
    this.events.left();
    this.dragged.ask((signal) => this.followOnce(mesh, signal));
  }

  /** Whether the cells of several sources are shown, or on their way. */
  get showsCells(): boolean {
    return this.wantsCells && this.placed().sources.length > 1;
  }

  /** Shows cells by colour, also of the sources that come, or distances again. */
  showCells(mesh: SurfaceMesh | undefined, wanted: boolean): void {
    const { shown } = this;
    this.wantsCells = wanted;
    if (!mesh || !shown) return;
    if (this.showsCells) {
      void this.paintCells(mesh, shown);
    } else {
      shown.paintDistances();
      this.events.repainted();
    }
  }

  /** Shows how far the field is from that of another algorithm. */
  async compare(mesh: SurfaceMesh, algorithm: Algorithm): Promise<Difference | undefined> {
    const { shown } = this;
    const question = { ...this.question(mesh), algorithm };
    const { signal } = this;
    const { distances } = await this.asking.answerTo(mesh, () => askDistances(this.asking.connection, question, signal));
    if (!shown || shown !== this.shown) return undefined;
    const difference = differenceOf(shown.distances, distances);
    this.wantsCells = false;
    this.against = algorithm;
    shown.paintDifference(difference);
    this.events.repainted();
    return difference;
  }

  // Shows the field nearly right.
  private async preview(question: FieldQuestion, field: FieldView, signal: AbortSignal): Promise<void> {
    try {
      const { distances } = await askDistances(
        this.asking.connection, { ...question, tolerance: PREVIEW_TOLERANCE }, signal);
      if (signal.aborted) return;
      field.showPreview(distances);
      this.events.changed();
      this.scene.redrawSurface();
      await this.sweep();
    } catch {
      // The exact field tells what is wrong.
    }
  }

  // Waits until the front has come to the end. What is asked for before then would
  // share the processors with the picture, if the server is on this machine.
  private async sweep(): Promise<void> {
    let swept: (() => void) | undefined;
    await new Promise<void>((resolve) => {
      this.swept = swept = resolve;
      setTimeout(resolve, LONGEST_SWEEP_MS);
    });
    // Another field may be waited for by now.
    if (this.swept === swept) this.swept = undefined;
  }

  private async paintCells(mesh: SurfaceMesh, field: FieldView): Promise<void> {
    try {
      const { signal } = this;
      const cells = await this.asking.answerTo(mesh, () => askCells(this.asking.connection, this.question(mesh), signal));
      if (field !== this.shown || !this.showsCells) return;
      field.paintCells(cells);
      this.events.repainted();
    } catch (error) {
      this.asking.reportAbout(mesh, error, () => this.paintCells(mesh, field));
    }
  }

  // Shows the field of the sources as they are, all at once.
  private async followOnce(mesh: SurfaceMesh, signal: AbortSignal): Promise<void> {
    const { sources } = this.placed();
    try {
      const question = this.newQuestion(mesh);
      const { distances, summary } = await this.asking.answerTo(mesh, () => askDistances(this.asking.connection, question, signal));
      if (signal.aborted) return;
      const field = this.begin(mesh, sources);
      field.setAll(distances);
      this.answer(summary, question);
      this.events.changed();
      this.scene.redrawSurface();
      if (this.showsCells) await this.paintCells(mesh, field);
    } catch (error) {
      this.asking.reportAbout(mesh, error, () => this.ask(mesh));
    }
  }

  private begin(mesh: SurfaceMesh, sources: readonly Source[]): FieldView {
    const [first] = sources;
    const place = "curve" in first ? first.curve[0] : first;
    const reference = onScreen(mesh, place);
    const allPoints = sources.every((source) => !("curve" in source));
    this.sources = sources;
    return (this.shown = new FieldView(mesh, this.scene.material, reference, allPoints));
  }

  // The question about a field that takes the place of the one there is.
  private newQuestion(mesh: SurfaceMesh): FieldQuestion {
    const question = this.question(mesh);
    this.reach = question.radius ?? Infinity;
    return question;
  }

  // Of a field that the server has further than the question the rest does not come.
  private answer(summary: FieldSummary, { radius }: FieldQuestion): void {
    this.reach = Math.min(summary.settledRadius, radius ?? Infinity);
    this.summary = { ...summary, settledRadius: this.reach };
  }
}
