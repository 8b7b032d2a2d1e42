// What is explored: one mesh, the sources on it, their field, and paths. Asks
// the questions and draws the answers.

import { Vector3 } from "three";
import type { Algorithm } from "../generated/geodesic/v1/query_pb";
import { Fields } from "./fields";
import { History } from "./history";
import { Lines } from "./lines";
import { areSame, isNothing, NOTHING, type Placed, type Sample } from "./placed";
import type { FieldView } from "./scene/field_view";
import { CURVE_COLOR, endOnScreen, Marks, onScreen } from "./scene/marks";
import { PathLine } from "./scene/path_line";
import type { Scene } from "./scene/scene";
import { Asking, type AskingEvents } from "./service/asking";
import type { Connection } from "./service/connection";
import { askCurve, type PathQuestion, type SurfaceLine } from "./service/lines";
import { askSamples, type FieldSummary } from "./service/questions";
import type { Difference } from "./surface/difference";
import type { LineQuestion, StraightLine } from "./surface/line_question";
import type { SurfaceMesh } from "./surface/mesh";
import type { Place, Source } from "./surface/place";

export interface ExplorerEvents extends AskingEvents {
  /** Sources, field, paths or samples are others now. */
  changed(): void;
  /** The distance under the cursor; exact once its path has come. */
  value(distance: number | undefined, exact: boolean): void;
  /** What was asked for has no answer, or another one: why, in words. */
  told(what: string): void;
}

export class Explorer {
  mesh: SurfaceMesh | undefined;
  readonly fields: Fields;

  private placed = NOTHING;
  private readonly history = new History<Placed>();
  private readonly asking: Asking;
  private readonly lines: Lines;
  private readonly sketch: PathLine;
  private readonly marks: Marks;

  constructor(
    private readonly scene: Scene,
    connection: Connection,
    private readonly events: ExplorerEvents,
  ) {
    this.asking = new Asking(connection, events);
    this.fields = new Fields(scene, this.asking, () => this.placed, {
      changed: () => events.changed(),
      repainted: () => {
        this.drawMarks();
        events.changed();
        scene.redrawSurface();
      },
      left: () => this.hideLive(),
    });
    this.lines = new Lines(scene, this.asking, {
      value: (length) => events.value(length, true),
      told: (what) => events.told(what),
      kept: (line) => void this.change(this.withPath(line)),
      came: (line) => void this.put(this.withPath(line)),
    });
    this.sketch = new PathLine(CURVE_COLOR, 3, scene.resolution);
    scene.overlay.add(this.sketch);
    this.marks = new Marks(scene);
  }

  get field(): FieldView | undefined {
    return this.fields.shown;
  }

  get summary(): FieldSummary | undefined {
    return this.fields.summary;
  }

  get sources(): readonly Source[] {
    return this.placed.sources;
  }

  get paths(): readonly SurfaceLine[] {
    return this.placed.paths;
  }

  /** Paths that an address named and that have not come. */
  get awaitedPaths(): readonly LineQuestion[] {
    return this.lines.awaited;
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

  /** The field of the sources as they are, once it is there and exact. */
  get exactField(): FieldView | undefined {
    return this.summary && areSame(this.sources, this.fields.sources) ? this.field : undefined;
  }

  /** Shows a mesh. What was placed on it stays if it is the one that is shown. */
  show(mesh: SurfaceMesh): void {
    const kept = mesh.digest === this.mesh?.digest ? this.placed : undefined;
    this.asking.show(mesh);
    this.mesh?.dispose();
    this.mesh = mesh;
    if (!kept) this.history.clear();
    this.placed = NOTHING;
    this.lines.awaited = [];
    this.fields.takeAway(this.mesh);
    this.showRadius(mesh);
    this.scene.show(mesh);
    this.lines.warmUp();
    this.marks.warmUp();
    this.scene.draw();
    this.lines.hide();
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
  async ask(sources: readonly Source[], paths: readonly LineQuestion[], radius: number | undefined, isChange: boolean): Promise<void> {
    const placed = { ...NOTHING, sources, radius };
    this.lines.awaited = paths;
    void (isChange ? this.change(placed) : this.put(placed));
    if (this.mesh) await this.lines.fetch(this.mesh, this.fields.algorithm);
  }

  /** Puts a source elsewhere while it is dragged by one gesture; the field follows. */
  moveSource(number: number, place: Place, gesture: object): void {
    const { mesh } = this;
    if (!mesh) return;
    this.history.record(this.placed, gesture);
    this.placed = { ...this.placed, sources: this.sources.map((source, i) => (i === number ? place : source)), samples: [] };
    this.drawMarks();
    this.scene.redraw();
    this.fields.follow(mesh);
  }

  /** Asks for the field again, as after a change of radius or method. */
  async askField(): Promise<void> {
    if (this.mesh) await this.fields.ask(this.mesh);
  }

  /** The source is where it was dragged to, whether its field has come or not. */
  dropSource(): void {
    this.events.changed();
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
      return await this.fields.compare(mesh, algorithm);
    } catch (error) {
      this.asking.report(error, () => undefined);
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
    this.lines.lead(mesh, this.pathTo(place), since);
  }

  /** Keeps the path to `place`. */
  async keepPath(place: Place): Promise<void> {
    if (this.mesh && this.sources.length) await this.lines.keep(this.mesh, this.pathTo(place));
  }

  /** How long lines are that run straight on; nothing without a field, or if it is 0. */
  get straightLength(): number | undefined {
    const largest = this.exactField?.largest;
    return (largest && (this.radius ?? largest)) || undefined;
  }

  /** Leads a line straight on from a source, in the direction of `place`. */
  leadStraight(from: Place, place: Place, since: number): void {
    const line = this.straightLine(from, place);
    if (this.mesh && line) this.lines.lead(this.mesh, line, since);
  }

  /** Keeps the line that `leadStraight` draws. */
  async keepStraight(from: Place, place: Place): Promise<void> {
    const line = this.straightLine(from, place);
    this.hideLive();
    if (this.mesh && line) await this.lines.keep(this.mesh, line);
  }

  removePath(path: SurfaceLine): void {
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
      const { signal } = this.asking;
      const curve = await this.asking.answerTo(mesh, () => askCurve(this.asking.connection, mesh.digest, places, signal));
      if (mesh !== this.mesh) return;
      await this.setSources([...(alone ? [] : this.sources), { curve }]);
    } catch (error) {
      this.asking.reportAbout(mesh, error, () => this.addCurve(places, alone));
    }
  }

  async sample(count: number): Promise<void> {
    const { mesh } = this;
    if (!mesh || !this.sources.length) return;
    const { signal } = this.fields;
    try {
      const samples = await this.asking.answerTo(mesh, () => askSamples(this.asking.connection, this.fields.question(mesh), count, signal));
      void this.change({ ...this.placed, samples });
    } catch (error) {
      this.asking.reportAbout(mesh, error, () => this.sample(count));
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
    if (!placed.sources.length) this.fields.takeAway(this.mesh);
    this.drawMarks();
    if (placed.sources.length && (!areSame(sources, placed.sources) || !this.fields.reaches(placed.radius))) {
      return this.askField();
    }
    this.events.changed();
    if (radius === placed.radius && field === this.field) this.scene.redraw();
    else this.scene.redrawSurface();
  }

  private showRadius(mesh: SurfaceMesh): void {
    const { radius } = this;
    this.scene.material.uniforms.radius.value = radius === undefined ? 1e10 : radius / mesh.radius;
  }

  private withPath(path: SurfaceLine): Placed {
    return { ...this.placed, paths: [...this.paths, path] };
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

  private pathTo(target: Place): PathQuestion {
    return { sources: this.sources, target, algorithm: this.fields.algorithm };
  }

  private straightLine(from: Place, towards: Place): StraightLine | undefined {
    const { mesh, straightLength } = this;
    if (!mesh || straightLength === undefined) return undefined;
    const [start, end] = [from, towards].map((place) => mesh.positionOf(place));
    return { from, direction: [end[0] - start[0], end[1] - start[1], end[2] - start[2]], length: straightLength };
  }

  private hideLive(): void {
    this.lines.hide();
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
    return mesh ? this.paths.map((path) => ({ point: endOnScreen(mesh, path), length: path.length })) : [];
  }
}
