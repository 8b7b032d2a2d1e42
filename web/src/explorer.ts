// What is explored: one mesh, the sources on it, their field, and paths. Asks
// the questions and draws the answers.

import { Vector3 } from "three";
import { Algorithm } from "../generated/geodesic/v1/query_pb";
import { CELL_COLORS } from "./scene/colormap";
import { Dots, type Dot } from "./scene/dots";
import { FieldView } from "./scene/field_view";
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
  type SurfacePath,
} from "./service/questions";
import { differenceOf, type Difference } from "./surface/difference";
import { PREVIEW_TOLERANCE, takesPreview } from "./surface/preview";
import type { SurfaceMesh } from "./surface/mesh";
import type { Place, Source } from "./surface/place";

const LIVE_COLOR = 0xffffff;
const KEPT_COLOR = 0xff8c42;
const CURVE_COLOR = 0x8fd3ff;
const WHITE = [1, 1, 1];
const SAMPLE_FILL = [0.55, 0.83, 1];
const KEPT_FILL = [1, 0.55, 0.26];

/** A path request that takes longer gives way to a newer cursor. */
const PATH_PATIENCE_MS = 250;

/** The exact field is asked for when what comes first has been swept over, or so much later. */
const LONGEST_SWEEP_MS = 1500;

/** Fields are worth waiting for, even if the source has moved on. */
const FIELD_PATIENCE_MS = 2000;

export interface KeptPath extends SurfacePath {
  target: Place;
}

export interface ExplorerEvents {
  /** Sources, field, paths or samples are others now. */
  changed(): void;
  /** The distance under the cursor; exact once its path has come. */
  value(distance: number | undefined, exact: boolean): void;
  /** A question failed; `again` asks it anew, if it still matters by then. */
  failed(error: unknown, again: () => void): void;
  /** The server has lost the mesh: whether it has it again. */
  lost(mesh: SurfaceMesh): Promise<boolean>;
}

export class Explorer {
  mesh: SurfaceMesh | undefined;
  field: FieldView | undefined;
  summary: FieldSummary | undefined;
  samples: { vertex: number; distance: number }[] = [];
  algorithm = Algorithm.UNSPECIFIED;
  /** In the unit of the file. */
  radius: number | undefined;
  readonly sources: Source[] = [];
  readonly paths: KeptPath[] = [];

  /** Up to where distances are there, or on their way. */
  private reach = Infinity;
  /** Whose distances the field has, or will have. */
  private fieldSources: readonly Source[] = [];
  private readonly live: PathLine;
  private readonly sketch: PathLine;
  private readonly lines = new Map<object, PathLine>();
  private readonly dots: Dots;
  private readonly sampleDots: Dots;
  private readonly underCursor = new NewestOnly(PATH_PATIENCE_MS);
  private readonly dragged = new NewestOnly(FIELD_PATIENCE_MS);
  private fieldQuestion = new AbortController();
  private waiting = false;
  private swept: (() => void) | undefined;
  private cursor: Place | undefined;
  private since = 0; // when the cursor came there
  private livePath: KeptPath | undefined;
  private readonly still = matchMedia("(prefers-reduced-motion: reduce)");

  constructor(
    private readonly scene: Scene,
    private readonly connection: Connection,
    private readonly events: ExplorerEvents,
  ) {
    this.live = new PathLine(LIVE_COLOR, 3, scene.resolution);
    this.dots = new Dots(15, scene);
    this.sampleDots = new Dots(10, scene);
    this.sketch = new PathLine(CURVE_COLOR, 3, scene.resolution);
    scene.overlay.add(this.live, this.sketch, this.sampleDots, this.dots);
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

  /** Whether an exact field is on its way. */
  get isWaiting(): boolean {
    return this.waiting;
  }

  /** The field of the sources as they are, once it is there and exact. */
  get exactField(): FieldView | undefined {
    const { sources, fieldSources } = this;
    const isTheirs = sources.length === fieldSources.length && sources.every((source, i) => source === fieldSources[i]);
    return this.summary && isTheirs ? this.field : undefined;
  }

  show(mesh: SurfaceMesh): void {
    this.clear();
    this.mesh?.dispose();
    this.mesh = mesh;
    this.setRadius(undefined);
    this.bareSurface(mesh);
    this.scene.show(mesh);
    // The first line or dot that a browser draws may take it some tenths of a second.
    this.live.setPoints(new Float32Array([-2, 0, 0, 2, 0, 0]));
    this.dots.setDots([{ point: [0, 0, 0], fill: WHITE }]);
    this.scene.draw();
    this.live.setPoints(new Float32Array());
    this.dots.setDots([]);
    this.scene.redraw();
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
    this.fieldQuestion.abort();
    this.underCursor.stop();
    this.dragged.stop();
    this.sources.length = 0;
    this.dropPaths();
    for (const line of this.lines.values()) this.removeLine(line);
    this.lines.clear();
    this.field = undefined;
    this.summary = undefined;
    this.reach = Infinity;
    this.waiting = false;
    this.samples = [];
    this.live.setPoints(new Float32Array());
    this.livePath = undefined;
    if (this.mesh) this.bareSurface(this.mesh);
    this.drawDots();
    this.events.value(undefined, false);
    this.events.changed();
    this.scene.redrawSurface();
  }

  /** Resolves when the field is there, or could not be had. */
  async setSources(sources: readonly Source[]): Promise<void> {
    this.dropPaths();
    this.sources.splice(0, this.sources.length, ...sources);
    this.samples = [];
    this.drawCurves();
    this.drawDots();
    if (sources.length) await this.askField();
    else this.clear();
  }

  /** Puts a source elsewhere while it is dragged; the field follows. */
  moveSource(number: number, place: Place): void {
    const { mesh } = this;
    if (!mesh) return;
    this.fieldQuestion.abort();
    this.fieldQuestion = new AbortController();
    this.waiting = false;
    this.hideLive();
    this.dropPaths();
    this.samples = [];
    this.sources[number] = place;
    this.drawDots();
    this.scene.redraw();
    this.dragged.ask((signal) => this.follow(mesh, signal));
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
    const field = this.beginField(mesh, [...this.sources]);
    document.documentElement.dataset.sweep = "";
    this.summary = undefined;
    this.waiting = true;
    this.events.changed();
    if (wasBare) this.scene.redraw();
    else this.scene.redrawSurface();
    const question = this.newQuestion(mesh);
    try {
      // Not both at once: they would share the server's processors.
      if (takesPreview(mesh, question)) await this.preview(mesh, question, field, abort.signal);
      const summary = await this.ask(mesh, () => askField(this.connection, question, (part) => {
        field.add(part.vertices, part.distances);
        if (!field.isPreview) this.scene.redrawSurface();
      }, abort.signal));
      if (abort.signal.aborted) return;
      this.answer(summary);
      field.finish();
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
  private async preview(mesh: SurfaceMesh, question: FieldQuestion, field: FieldView, signal: AbortSignal): Promise<void> {
    try {
      const { distances } = await askDistances(
        this.connection, { ...question, tolerance: PREVIEW_TOLERANCE }, mesh.vertexCount, signal);
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

  /** Shows cells by colour, or distances again. */
  async showCells(shown: boolean): Promise<void> {
    const { mesh, field } = this;
    if (!mesh || !field) return;
    try {
      if (shown) {
        const { signal } = this.fieldQuestion;
        const cells = await this.ask(mesh, () => askCells(
          this.connection, this.question(mesh), mesh.vertexCount, signal));
        if (field !== this.field) return;
        field.paintCells(cells);
      } else {
        field.paintDistances();
      }
      this.repainted();
    } catch (error) {
      this.reportAbout(mesh, error, () => this.showCells(shown));
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
      const { distances } = await this.ask(mesh, () => askDistances(
        this.connection, question, mesh.vertexCount, signal));
      if (!field || field !== this.field) return undefined;
      const difference = differenceOf(field.distances, distances);
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
    this.cursor = place;
    if (!place || !this.field || !this.mesh) {
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
    this.since = since;
    this.askUnderCursor();
  }

  /** Keeps the path to `place`. */
  async keepPath(place: Place): Promise<void> {
    const { mesh } = this;
    if (!mesh || !this.sources.length) return;
    const { signal } = this.fieldQuestion;
    try {
      const path = this.livePath?.target === place
        ? this.livePath
        : await this.ask(mesh, () => askPath(this.connection, this.question(mesh), place, signal));
      // The second click of two leads from the source to itself.
      if (path && path.length > 0 && mesh === this.mesh) this.addPath({ ...path, target: place });
    } catch (error) {
      this.reportAbout(mesh, error, () => this.keepPath(place));
    }
  }

  removePath(path: KeptPath): void {
    const line = this.lines.get(path);
    if (line) this.removeLine(line);
    this.lines.delete(path);
    this.paths.splice(this.paths.indexOf(path), 1);
    this.drawDots();
    this.events.changed();
    this.scene.redraw();
  }

  /** Takes the last path away, or else the last source. */
  undo(): void {
    const path = this.paths.at(-1);
    if (path) this.removePath(path);
    else void this.setSources(this.sources.slice(0, -1));
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
      const { signal } = new AbortController();
      const curve = await this.ask(mesh, () => askCurve(this.connection, mesh.digest, places, signal));
      if (mesh !== this.mesh) return;
      await this.setSources([...(alone ? [] : this.sources), { curve: curve.places }]);
    } catch (error) {
      this.reportAbout(mesh, error, () => this.addCurve(places, alone));
    }
  }

  async sample(count: number): Promise<void> {
    const { mesh } = this;
    if (!mesh || !this.sources.length) return;
    const { signal } = this.fieldQuestion;
    try {
      this.samples = await this.ask(mesh, () => askSamples(this.connection, this.question(mesh), count, signal));
      this.drawDots();
      this.events.changed();
      this.scene.redraw();
    } catch (error) {
      this.reportAbout(mesh, error, () => this.sample(count));
    }
  }

  /** Shows distances up to here only; asks for what is not there. */
  setRadius(radius: number | undefined): void {
    this.radius = radius;
    if (!this.mesh) return;
    this.scene.material.uniforms.radius.value = radius === undefined ? 1e10 : radius / this.mesh.radius;
    this.scene.redrawSurface();
    this.events.changed();
    if ((radius ?? Infinity) > this.reach) void this.askField();
  }

  private async moveToVertices(mesh: SurfaceMesh): Promise<void> {
    const places = this.sources.map((source) => {
      if ("curve" in source) throw new Error("Approximate algorithms take points, no curves.");
      return source;
    });
    if (places.every((place) => place.kind === "vertex")) return;
    await this.setSources(places.map((place) => ({ kind: "vertex", vertex: mesh.nearestCorner(place) })));
  }

  private repainted(): void {
    this.drawDots();
    this.events.changed();
    this.scene.redrawSurface();
  }

  private question(mesh: SurfaceMesh): FieldQuestion {
    return { digest: mesh.digest, sources: [...this.sources], algorithm: this.algorithm, radius: this.radius };
  }

  // The question about a field that takes the place of the one there is.
  private newQuestion(mesh: SurfaceMesh): FieldQuestion {
    this.reach = this.radius ?? Infinity;
    return this.question(mesh);
  }

  private answer(summary: FieldSummary): void {
    this.summary = summary;
    this.reach = summary.settledRadius;
  }

  // Shows the field of the sources as they are, all at once.
  private async follow(mesh: SurfaceMesh, signal: AbortSignal): Promise<void> {
    const sources = [...this.sources];
    try {
      const question = this.newQuestion(mesh);
      const { distances, summary } = await this.ask(mesh, () => askDistances(
        this.connection, question, mesh.vertexCount, signal));
      if (mesh !== this.mesh || signal.aborted) return;
      this.beginField(mesh, sources).setAll(distances);
      this.answer(summary);
      this.events.changed();
      this.scene.redrawSurface();
    } catch (error) {
      this.reportAbout(mesh, error, () => this.askField());
    }
  }

  private beginField(mesh: SurfaceMesh, sources: readonly Source[]): FieldView {
    const [first] = sources;
    const place = "curve" in first ? first.curve[0] : first;
    const [reference] = this.onScreen(mesh, [place]);
    const allPoints = sources.every((source) => !("curve" in source));
    this.fieldSources = sources;
    return (this.field = new FieldView(mesh, this.scene.material, reference, allPoints));
  }

  // Asks for the path under the cursor and draws it.
  private async lead(mesh: SurfaceMesh, target: Place, since: number, signal: AbortSignal): Promise<void> {
    try {
      const question = { ...this.question(mesh), radius: undefined };
      const path = await this.ask(mesh, () => askPath(this.connection, question, target, signal));
      if (mesh !== this.mesh || !this.cursor || signal.aborted) return;
      this.livePath = path && { ...path, target };
      this.live.setPoints(path ? mesh.toScreen(path.positions) : new Float32Array());
      this.events.value(path?.distance ?? Infinity, true);
      this.scene.draw();
      performance.measure("path under the cursor", { start: since, end: performance.now() });
    } catch (error) {
      this.report(error, this.askUnderCursor);
    }
  }

  private readonly askUnderCursor = (): void => {
    const { mesh, cursor, since } = this;
    if (mesh && cursor && this.field) this.underCursor.ask((signal) => this.lead(mesh, cursor, since, signal));
  };

  private hideLive(): void {
    this.underCursor.stop();
    this.events.value(undefined, false);
    if (!this.live.visible) return;
    this.live.setPoints(new Float32Array());
    this.livePath = undefined;
    this.scene.redraw();
  }

  private addPath(path: KeptPath): void {
    this.paths.push(path);
    this.addLine(path, KEPT_COLOR, path.positions);
    this.drawDots();
    this.events.changed();
    this.scene.redraw();
  }

  private addLine(owner: object, color: number, positions: Float64Array): void {
    if (!this.mesh) return;
    const line = new PathLine(color, 3, this.scene.resolution);
    line.setPoints(this.mesh.toScreen(positions));
    this.lines.set(owner, line);
    this.scene.overlay.add(line);
  }

  private removeLine(line: PathLine): void {
    this.scene.overlay.remove(line);
    line.dispose();
  }

  private dropPaths(): void {
    for (const path of [...this.paths]) this.removePath(path);
  }

  private drawCurves(): void {
    const { mesh } = this;
    if (!mesh) return;
    for (const [owner, line] of this.lines) {
      this.removeLine(line);
      this.lines.delete(owner);
    }
    for (const source of this.sources) {
      if (!("curve" in source)) continue;
      const positions = new Float64Array(source.curve.flatMap((place) => mesh.positionOf(place)));
      this.addLine(source, CURVE_COLOR, positions);
    }
  }

  private drawDots(): void {
    const { mesh } = this;
    if (!mesh) return;
    const dots: Dot[] = [];
    this.sources.forEach((source, i) => {
      if ("curve" in source) return;
      const cell = CELL_COLORS[i % CELL_COLORS.length].map((byte) => byte / 255);
      dots.push({ point: this.onScreen(mesh, [source])[0].toArray(), fill: this.field?.painted === "cells" ? cell : WHITE });
    });
    for (const path of this.paths) {
      dots.push({ point: this.onScreen(mesh, [path.target])[0].toArray(), fill: KEPT_FILL });
    }
    this.dots.setDots(dots);
    const samples = this.samples.map(({ vertex }): Place => ({ kind: "vertex", vertex }));
    this.sampleDots.setDots(this.onScreen(mesh, samples).map((p) => ({ point: p.toArray(), fill: SAMPLE_FILL })));
  }

  /** Where the sources are on the screen's scale; nothing for curves. */
  sourcesOnScreen(): (Vector3 | undefined)[] {
    const { mesh } = this;
    return this.sources.map((source) => (mesh && !("curve" in source) ? this.onScreen(mesh, [source])[0] : undefined));
  }

  /** Where kept paths end, on the screen's scale, and how long they are. */
  pathEnds(): { point: Vector3; length: number }[] {
    const { mesh } = this;
    if (!mesh) return [];
    return this.paths.map(({ target, length }) => ({ point: this.onScreen(mesh, [target])[0], length }));
  }

  private onScreen(mesh: SurfaceMesh, places: readonly Place[]): Vector3[] {
    return places.map((place) => new Vector3(...mesh.toScreen(new Float64Array(mesh.positionOf(place)))));
  }

  private bareSurface(mesh: SurfaceMesh): void {
    new FieldView(mesh, this.scene.material, new Vector3(), true);
  }

  private ask<T>(mesh: SurfaceMesh, question: () => Promise<T>): Promise<T> {
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
