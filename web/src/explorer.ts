// What is explored: one mesh, the sources on it, their field, and paths. Asks
// the questions and draws the answers.

import { Vector3 } from "three";
import { Algorithm } from "../generated/geodesic/v1/query_pb";
import { History } from "./history";
import { areSame, isNothing, keptPath, NOTHING, type KeptPath, type PathEnds, type Placed, type Sample } from "./placed";
import { CursorPath } from "./scene/cursor_path";
import { FieldView } from "./scene/field_view";
import { CURVE_COLOR, Marks, onScreen } from "./scene/marks";
import { PathLine } from "./scene/path_line";
import type { Scene } from "./scene/scene";
import type { Connection } from "./service/connection";
import { askRestoring } from "./service/ask_restoring";
import { kindOf } from "./service/errors";
import { NewestOnly } from "./service/newest_only";
import {
  askCells,
  askCurve,
  askDistances,
  askField,
  askPath,
  askSamples,
  type FieldQuestion,
  type FieldSummary,
} from "./service/questions";
import { differenceOf, type Difference } from "./surface/difference";
import { PREVIEW_TOLERANCE, takesPreview } from "./surface/preview";
import type { SurfaceMesh } from "./surface/mesh";
import type { Place, Source } from "./surface/place";

/** The exact field is asked for when what comes first has been swept over, or so much later. */
const LONGEST_SWEEP_MS = 1500;

/** Fields are worth waiting for, even if the source has moved on. */
const FIELD_PATIENCE_MS = 2000;

export interface ExplorerEvents {
  /** Sources, field, paths or samples are others now. */
  changed(): void;
  /** The distance under the cursor; exact once its path has come. */
  value(distance: number | undefined, exact: boolean): void;
  /** A question failed; `again` asks it anew, if it still matters by then. */
  failed(error: unknown, again: () => void): void;
  /** What was asked for has no answer, or another one: why, in words. */
  told(what: string): void;
  /** The server has lost the mesh: whether it has it again. */
  lost(mesh: SurfaceMesh): Promise<boolean>;
}

export class Explorer {
  mesh: SurfaceMesh | undefined;
  field: FieldView | undefined;
  summary: FieldSummary | undefined;
  algorithm = Algorithm.UNSPECIFIED;
  /** The algorithm whose field the difference is from. */
  against = Algorithm.UNSPECIFIED;
  /** Whose distances the field has, or will have. */
  fieldSources: readonly Source[] = [];
  /** Whether cells are wanted where there are several sources. */
  wantsCells = false;
  /** Paths that an address named and that have not come. */
  awaitedPaths: readonly PathEnds[] = [];

  private placed = NOTHING;
  private readonly history = new History<Placed>();
  /** Up to where distances are there, or on their way. */
  private reach = Infinity;
  private readonly live: CursorPath;
  private readonly sketch: PathLine;
  private readonly marks: Marks;
  private readonly dragged = new NewestOnly(FIELD_PATIENCE_MS);
  private fieldQuestion = new AbortController();
  /** Of what is asked about the mesh, whatever the sources. */
  private meshQuestions = new AbortController();
  private waiting = false;
  private swept: (() => void) | undefined;
  private readonly still = matchMedia("(prefers-reduced-motion: reduce)");

  constructor(
    private readonly scene: Scene,
    private readonly connection: Connection,
    private readonly events: ExplorerEvents,
  ) {
    this.live = new CursorPath(scene, {
      ask: (mesh, target, signal) => {
        const question = { ...this.question(mesh), radius: undefined };
        return this.answerTo(mesh, () => askPath(this.connection, question, target, signal));
      },
      value: (distance) => events.value(distance, true),
      failed: (error, again) => this.report(error, again),
    });
    this.sketch = new PathLine(CURVE_COLOR, 3, scene.resolution);
    scene.overlay.add(this.sketch);
    this.marks = new Marks(scene);
    scene.onFrame = (now) => {
      const moved = this.field?.advance(now, this.still.matches) ?? false;
      if (this.field?.hasSwept) this.swept?.();
      document.documentElement.dataset.sweep = this.field?.hasArrived ? "done" : this.field?.hasSwept ? "preview" : "";
      return moved;
    };
    scene.isWaiting = () => this.waiting && !this.swept;
    // Until the whole field is there and swept, or could not be had.
    scene.isBusy = () => this.waiting || (this.summary !== undefined && this.field?.hasArrived === false);
  }

  get sources(): readonly Source[] {
    return this.placed.sources;
  }

  get paths(): readonly KeptPath[] {
    return this.placed.paths;
  }

  get samples(): readonly Sample[] {
    return this.placed.samples;
  }

  /** In the unit of the file; nothing for all. */
  get radius(): number | undefined {
    return this.placed.radius;
  }

  get isEmpty(): boolean {
    return isNothing(this.placed);
  }

  get canUndo(): boolean {
    return this.history.canUndo;
  }

  get canRedo(): boolean {
    return this.history.canRedo;
  }

  /** Whether an exact field is on its way. */
  get isWaiting(): boolean {
    return this.waiting;
  }

  /** The field of the sources as they are, once it is there and exact. */
  get exactField(): FieldView | undefined {
    return this.summary && areSame(this.sources, this.fieldSources) ? this.field : undefined;
  }

  /** Shows a mesh. What was placed on it stays if it is the one that is shown. */
  show(mesh: SurfaceMesh): void {
    const kept = mesh.digest === this.mesh?.digest ? this.placed : undefined;
    this.meshQuestions.abort();
    this.meshQuestions = new AbortController();
    this.mesh?.dispose();
    this.mesh = mesh;
    if (!kept) this.history.clear();
    this.placed = NOTHING;
    this.awaitedPaths = [];
    this.takeFieldAway();
    this.showRadius(mesh);
    this.scene.show(mesh);
    this.live.warmUp();
    this.marks.warmUp();
    this.scene.draw();
    this.live.hide();
    void this.put(kept ?? NOTHING);
  }

  /** Draws these faces while the picture changes; without them, all. */
  showCoarse(mesh: SurfaceMesh, indices: Uint32Array | undefined): void {
    if (mesh !== this.mesh) return;
    mesh.awaitsCoarse = false;
    if (indices) mesh.setCoarse(indices);
    this.events.changed();
    this.scene.redrawSurface();
  }

  /** Takes everything off the mesh. */
  clear(): void {
    if (!this.isEmpty) void this.change(NOTHING);
  }

  /** Resolves when the field is there, or could not be had. Paths stay. */
  setSources(sources: readonly Source[]): Promise<void> {
    return this.change({ ...this.placed, sources, samples: [] });
  }

  /** Goes back to what there was before the last change. */
  undo(): void {
    this.goTo(this.history.undo(this.placed));
  }

  redo(): void {
    this.goTo(this.history.redo(this.placed));
  }

  /** Goes back to where a gesture began, if it was the last change. */
  cancel(gesture: object): void {
    this.goTo(this.history.cancel(gesture));
  }

  /**
   * What an address asks takes the place of what there is; its paths come one by
   * one. It can be undone if `isChange`: if the mesh was shown before.
   */
  async ask(sources: readonly Source[], paths: readonly PathEnds[], radius: number | undefined, isChange: boolean): Promise<void> {
    const placed = { ...NOTHING, sources, radius };
    this.awaitedPaths = paths;
    void (isChange ? this.change(placed) : this.put(placed));
    await this.fetchPaths(this.meshQuestions.signal);
  }

  /** Puts a source elsewhere while it is dragged by one gesture; the field follows. */
  moveSource(number: number, place: Place, gesture: object): void {
    const { mesh } = this;
    if (!mesh) return;
    this.history.record(this.placed, gesture);
    this.fieldQuestion.abort();
    this.fieldQuestion = new AbortController();
    this.waiting = false;
    this.hideLive();
    this.placed = { ...this.placed, sources: this.sources.map((source, i) => (i === number ? place : source)), samples: [] };
    this.drawMarks();
    this.scene.redraw();
    this.dragged.ask((signal) => this.follow(mesh, signal));
  }

  /** The source is where it was dragged to, whether its field has come or not. */
  dropSource(): void {
    this.events.changed();
  }

  /** Asks for the field again, as after a change of radius or method. */
  async askField(): Promise<void> {
    const { mesh } = this;
    if (!mesh || !this.sources.length) return;
    this.fieldQuestion.abort();
    this.dragged.stop();
    this.hideLive();
    const abort = (this.fieldQuestion = new AbortController());
    const wasBare = !this.field;
    const field = this.beginField(mesh, this.sources);
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
      const summary = await this.answerTo(mesh, () => askField(this.connection, question, (part) => {
        field.add(part.vertices, part.distances);
        if (!field.isPreview) this.scene.redrawSurface();
      }, abort.signal));
      if (abort.signal.aborted) return;
      this.answer(summary, question);
      field.finish();
      if (this.showsCells) void this.paintCells(mesh, field);
    } catch (error) {
      this.report(error, () => {
        if (abort === this.fieldQuestion) void this.askField();
      });
    } finally {
      if (abort === this.fieldQuestion) this.waiting = false;
      this.events.changed();
      this.scene.redrawSurface();
    }
  }

  // Shows the field nearly right.
  private async preview(question: FieldQuestion, field: FieldView, signal: AbortSignal): Promise<void> {
    try {
      const { distances } = await askDistances(
        this.connection, { ...question, tolerance: PREVIEW_TOLERANCE }, signal);
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

  /** Whether the cells of several sources are shown, or on their way. */
  get showsCells(): boolean {
    return this.wantsCells && this.sources.length > 1;
  }

  /** Shows cells by colour, also of the sources that come, or distances again. */
  showCells(wanted: boolean): void {
    const { mesh, field } = this;
    this.wantsCells = wanted;
    if (!mesh || !field) return;
    if (this.showsCells) {
      void this.paintCells(mesh, field);
    } else {
      field.paintDistances();
      this.repainted();
    }
  }

  private async paintCells(mesh: SurfaceMesh, field: FieldView): Promise<void> {
    try {
      const { signal } = this.fieldQuestion;
      const cells = await this.answerTo(mesh, () => askCells(this.connection, this.question(mesh), signal));
      if (field !== this.field || !this.showsCells) return;
      field.paintCells(cells);
      this.repainted();
    } catch (error) {
      this.reportAbout(mesh, error, () => this.paintCells(mesh, field));
    }
  }

  /**
   * Shows how far the field is from that of another algorithm. Approximate ones
   * measure between vertices, so sources move to the nearest ones for them.
   */
  async compare(algorithm: Algorithm, isApproximate: boolean): Promise<Difference | undefined> {
    const { mesh } = this;
    if (!mesh || !this.summary) return undefined;
    try {
      if (isApproximate) await this.moveToVertices(mesh);
      const { field } = this;
      const question = { ...this.question(mesh), algorithm };
      const { signal } = this.fieldQuestion;
      const { distances } = await this.answerTo(mesh, () => askDistances(this.connection, question, signal));
      if (!field || field !== this.field) return undefined;
      const difference = differenceOf(field.distances, distances);
      this.wantsCells = false;
      this.against = algorithm;
      field.paintDifference(difference);
      this.repainted();
      return difference;
    } catch (error) {
      this.report(error, () => undefined);
      return undefined;
    }
  }

  /** Leads the path to `place`; `since` is when the cursor came there. */
  hover(place: Extract<Place, { kind: "face" }> | undefined, since: number): void {
    const { mesh } = this;
    if (!place || !this.field || !mesh) {
      this.hideLive();
      return;
    }
    const drawn = this.field.at(place.face, place.weights);
    // What is grey may be reached all the same: its path will tell.
    this.events.value(drawn === Infinity ? undefined : drawn, false);
    if (this.summary && drawn === Infinity && this.summary.settledRadius === Infinity) {
      this.hideLive();
      this.events.value(Infinity, true);
      return;
    }
    this.live.lead(mesh, place, since);
  }

  /** Keeps the path to `place`. */
  async keepPath(place: Place): Promise<void> {
    const { mesh } = this;
    if (!mesh || !this.sources.length) return;
    const question = this.question(mesh);
    const { signal } = this.meshQuestions;
    try {
      const path = await this.answerTo(mesh, () => askPath(this.connection, question, place, signal));
      if (mesh !== this.mesh) return;
      if (!path) this.events.told("No path leads there.");
      // The second click of two leads from the source to itself.
      else if (path.length > 0) void this.change(this.withPath(keptPath(path, question.sources, place)));
    } catch (error) {
      this.reportAbout(mesh, error, () => this.keepPath(place));
    }
  }

  removePath(path: KeptPath): void {
    void this.change({ ...this.placed, paths: this.paths.filter((kept) => kept !== path) });
  }

  /** Takes the last path away, or else the last source. */
  removeLast(): void {
    const path = this.paths.at(-1);
    if (path) this.removePath(path);
    else if (this.sources.length) void this.setSources(this.sources.slice(0, -1));
  }

  /** A curve while it is drawn: points on the screen's scale. */
  drawSketch(points: readonly Vector3[]): void {
    this.sketch.setPoints(new Float32Array(points.flatMap((point) => point.toArray())));
    this.scene.redraw();
  }

  /** Makes sources of every point of the curve that runs through `places`. */
  async addCurve(places: readonly Place[], alone: boolean): Promise<void> {
    const { mesh } = this;
    this.drawSketch([]);
    if (!mesh || places.length < 2) return;
    try {
      const { signal } = this.meshQuestions;
      const curve = await this.answerTo(mesh, () => askCurve(this.connection, mesh.digest, places, signal));
      if (mesh !== this.mesh) return;
      await this.setSources([...(alone ? [] : this.sources), { curve }]);
    } catch (error) {
      this.reportAbout(mesh, error, () => this.addCurve(places, alone));
    }
  }

  async sample(count: number): Promise<void> {
    const { mesh } = this;
    if (!mesh || !this.sources.length) return;
    const { signal } = this.fieldQuestion;
    try {
      const samples = await this.answerTo(mesh, () => askSamples(this.connection, this.question(mesh), count, signal));
      void this.change({ ...this.placed, samples });
    } catch (error) {
      this.reportAbout(mesh, error, () => this.sample(count));
    }
  }

  /** Shows distances up to here only; asks for what is not there. Changes in a row are undone as one. */
  setRadius(radius: number | undefined): void {
    if (radius !== this.radius) void this.change({ ...this.placed, radius }, "radius");
  }

  // Puts this in the place of what there is, which can be gone back to.
  private change(placed: Placed, gesture?: unknown): Promise<void> {
    this.history.record(this.placed, gesture);
    return this.put(placed);
  }

  private goTo(placed: Placed | undefined): void {
    if (placed) void this.put(placed);
  }

  // Asks for the field if it is another one.
  private async put(placed: Placed): Promise<void> {
    const { sources, radius, field } = this;
    this.placed = placed;
    if (this.mesh) this.showRadius(this.mesh);
    if (!placed.sources.length) this.takeFieldAway();
    this.drawMarks();
    if (placed.sources.length && (!areSame(sources, placed.sources) || (placed.radius ?? Infinity) > this.reach)) {
      return this.askField();
    }
    this.events.changed();
    if (radius === placed.radius && field === this.field) this.scene.redraw();
    else this.scene.redrawSurface();
  }

  private takeFieldAway(): void {
    this.fieldQuestion.abort();
    this.dragged.stop();
    this.hideLive();
    this.field = undefined;
    this.fieldSources = [];
    this.summary = undefined;
    this.reach = Infinity;
    this.waiting = false;
    if (this.mesh) new FieldView(this.mesh, this.scene.material, new Vector3(), true);
  }

  private showRadius(mesh: SurfaceMesh): void {
    const { radius } = this;
    this.scene.material.uniforms.radius.value = radius === undefined ? 1e10 : radius / mesh.radius;
  }

  private withPath(path: KeptPath): Placed {
    return { ...this.placed, paths: [...this.paths, path] };
  }

  // The paths that an address named are no change of what it asked.
  private async fetchPaths(signal: AbortSignal): Promise<void> {
    const { mesh } = this;
    if (!mesh) return;
    try {
      for (let next = this.awaitedPaths[0]; next && !signal.aborted; next = this.awaitedPaths[0]) {
        const { from, target } = next;
        const question = { digest: mesh.digest, sources: [from], algorithm: this.algorithm };
        const path = await this.answerTo(mesh, () => askPath(this.connection, question, target, signal));
        if (next !== this.awaitedPaths[0]) continue;
        this.awaitedPaths = this.awaitedPaths.slice(1);
        if (path) await this.put(this.withPath(keptPath(path, [from], target)));
        else this.events.told("The address names a path between places that nothing connects.");
      }
    } catch (error) {
      this.reportAbout(mesh, error, () => this.fetchPaths(signal));
    }
  }

  private async moveToVertices(mesh: SurfaceMesh): Promise<void> {
    const places = this.sources.map((source) => {
      if ("curve" in source) throw new Error("Approximate algorithms take points, no curves.");
      return source;
    });
    if (places.every((place) => place.kind === "vertex")) return;
    this.events.told("Sources are at the nearest vertices now: approximate algorithms measure between vertices.");
    await this.setSources(places.map((place) => ({ kind: "vertex", vertex: mesh.nearestCorner(place) })));
  }

  private repainted(): void {
    this.drawMarks();
    this.events.changed();
    this.scene.redrawSurface();
  }

  private question(mesh: SurfaceMesh): FieldQuestion {
    return { digest: mesh.digest, sources: this.sources, algorithm: this.algorithm, radius: this.radius };
  }

  // The question about a field that takes the place of the one there is.
  private newQuestion(mesh: SurfaceMesh): FieldQuestion {
    this.reach = this.radius ?? Infinity;
    return this.question(mesh);
  }

  // Of a field that the server has further than the question the rest does not come.
  private answer(summary: FieldSummary, { radius }: FieldQuestion): void {
    this.reach = Math.min(summary.settledRadius, radius ?? Infinity);
    this.summary = { ...summary, settledRadius: this.reach };
  }

  // Shows the field of the sources as they are, all at once.
  private async follow(mesh: SurfaceMesh, signal: AbortSignal): Promise<void> {
    const { sources } = this;
    try {
      const question = this.newQuestion(mesh);
      const { distances, summary } = await this.answerTo(mesh, () => askDistances(this.connection, question, signal));
      if (mesh !== this.mesh || signal.aborted) return;
      const field = this.beginField(mesh, sources);
      field.setAll(distances);
      this.answer(summary, question);
      this.events.changed();
      this.scene.redrawSurface();
      if (this.showsCells) await this.paintCells(mesh, field);
    } catch (error) {
      this.reportAbout(mesh, error, () => this.askField());
    }
  }

  private beginField(mesh: SurfaceMesh, sources: readonly Source[]): FieldView {
    const [first] = sources;
    const place = "curve" in first ? first.curve[0] : first;
    const reference = onScreen(mesh, place);
    const allPoints = sources.every((source) => !("curve" in source));
    this.fieldSources = sources;
    return (this.field = new FieldView(mesh, this.scene.material, reference, allPoints));
  }

  private hideLive(): void {
    this.live.hide();
    this.events.value(undefined, false);
  }

  private drawMarks(): void {
    if (this.mesh) this.marks.show(this.mesh, this.placed, this.field?.painted === "cells");
  }

  /** Where the sources are on the screen's scale; nothing for curves. */
  sourcesOnScreen(): (Vector3 | undefined)[] {
    const { mesh } = this;
    return this.sources.map((source) => (mesh && !("curve" in source) ? onScreen(mesh, source) : undefined));
  }

  /** Where kept paths end, on the screen's scale, and how long they are. */
  pathEnds(): { point: Vector3; length: number }[] {
    const { mesh } = this;
    if (!mesh) return [];
    return this.paths.map(({ target, length }) => ({ point: onScreen(mesh, target), length }));
  }

  private answerTo<T>(mesh: SurfaceMesh, question: () => Promise<T>): Promise<T> {
    return askRestoring(question, () => this.events.lost(mesh));
  }

  // The work is done again only while the mesh is shown.
  private reportAbout(mesh: SurfaceMesh, error: unknown, work: () => Promise<void>): void {
    this.report(error, () => {
      if (mesh === this.mesh) void work();
    });
  }

  private report(error: unknown, again: () => void): void {
    if (kindOf(error) !== "cancelled") this.events.failed(error, again);
  }
}
