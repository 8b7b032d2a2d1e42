// A field as it comes and as it is drawn: the front moves outwards no faster
// than the eye follows, and never beyond what is final.

import { BufferAttribute, DynamicDrawUsage, Vector3 } from "three";
import type { Difference } from "../surface/difference";
import type { SurfaceMesh } from "../surface/mesh";
import type { Weights } from "../surface/place";
import { CELL_COLORS, COLORMAP, COLORMAP_SIZE } from "./colormap";
import { chooseIsolines } from "./isoline_scale";
import type { SurfaceMaterial } from "./surface_material";

const SWEEP_MS = 700;

export class FieldView {
  /** Of each vertex, in the unit of the file; +infinity where none is known. */
  readonly distances: Float64Array;
  painted: "distances" | "cells" | "difference" = "distances";
  /** From another field, once it was painted. */
  difference: Difference | undefined;
  /** The greatest finite distance. */
  largest = 0;
  private readonly drawn: Float32Array;
  private readonly attribute: BufferAttribute;
  private preview: Float64Array | undefined;
  private complete = false;
  private arrived = false;
  private swept = false;
  private front = 0;
  private lastFrame = 0;

  /** `reference` is the place of a source, on the screen's scale. */
  constructor(
    private readonly mesh: SurfaceMesh,
    private readonly material: SurfaceMaterial,
    reference: Vector3,
    private readonly quadratic: boolean,
  ) {
    this.distances = new Float64Array(mesh.vertexCount).fill(Infinity);
    this.drawn = new Float32Array(mesh.vertexCount).fill(-1);
    this.attribute = new BufferAttribute(this.drawn, 1).setUsage(DynamicDrawUsage);
    mesh.setAttribute("geodesic", this.attribute);
    material.uniforms.reference.value = reference;
    material.uniforms.quadratic.value = quadratic;
    this.paintDistances();
    this.setFront(0);
  }

  add(vertices: Uint32Array, distances: Float64Array): void {
    for (let i = 0; i < vertices.length; i++) {
      this.distances[vertices[i]] = distances[i];
      this.drawn[vertices[i]] = distances[i] / this.mesh.radius;
    }
    // They come in order.
    if (distances.length) this.largest = Math.max(this.largest, distances[distances.length - 1]);
    this.attribute.needsUpdate = true;
    this.setScale();
  }

  /** Shows a field that is whole already, without a sweep. */
  setAll(distances: Float64Array): void {
    this.distances.set(distances);
    for (let v = 0; v < distances.length; v++) {
      if (!Number.isFinite(distances[v])) continue;
      this.drawn[v] = distances[v] / this.mesh.radius;
      this.largest = Math.max(this.largest, distances[v]);
    }
    this.arrived = true;
    this.attribute.needsUpdate = true;
    this.setScale();
    this.setFront(Infinity);
  }

  /** Shows these distances where final ones have not come, until all have. */
  showPreview(distances: Float64Array): void {
    if (this.complete) return;
    this.preview = distances;
    for (let v = 0; v < distances.length; v++) {
      if (!Number.isFinite(distances[v]) || Number.isFinite(this.distances[v])) continue;
      this.drawn[v] = distances[v] / this.mesh.radius;
      this.largest = Math.max(this.largest, distances[v]);
    }
    this.attribute.needsUpdate = true;
    this.setScale();
  }

  /** Whether some of what is shown is not final. */
  get isPreview(): boolean {
    return this.preview !== undefined;
  }

  /** All has come. */
  finish(): void {
    this.complete = true;
    if (!this.preview) return;
    this.preview = undefined;
    this.largest = 0;
    for (let v = 0; v < this.distances.length; v++) {
      if (Number.isFinite(this.distances[v])) this.largest = Math.max(this.largest, this.distances[v]);
      else this.drawn[v] = -1;
    }
    this.attribute.needsUpdate = true;
    this.setScale();
  }

  /** Whether the front has come to the end of what there is. */
  get hasArrived(): boolean {
    return this.arrived;
  }

  /** Whether it has come over all of the surface, be it over what is not final. */
  get hasSwept(): boolean {
    return this.swept;
  }

  /** Moves the front; returns whether the picture is another one now. */
  advance(now: number, hasten: boolean): boolean {
    if (this.arrived) return false;
    if (!this.complete && !this.preview && !this.largest) {
      // Nothing has come: the front has not begun.
      this.lastFrame = 0;
      return false;
    }
    const end = this.largest / this.mesh.radius;
    // Slow pictures make no slower front.
    const passed = this.lastFrame ? Math.min(now - this.lastFrame, SWEEP_MS) : 16;
    this.lastFrame = now;
    const before = this.front;
    if (hasten) this.front = end;
    this.front = Math.min(this.front + (end * passed) / SWEEP_MS, end);
    this.swept = this.front >= end && (this.complete || this.preview !== undefined);
    this.arrived = this.complete && this.swept;
    // Where a preview has been swept over, final distances change no picture to see.
    this.setFront(this.swept ? Infinity : this.front);
    return this.preview === undefined || before < end;
  }

  /** Colours the cell of each source, by the number of the nearest one. */
  paintCells(cells: Uint32Array): void {
    const colors = new Uint8Array(3 * cells.length).fill(128);
    for (let v = 0; v < cells.length; v++) {
      if (cells[v] !== 0xffffffff) colors.set(CELL_COLORS[cells[v] % CELL_COLORS.length], 3 * v);
    }
    // Darker far from the source.
    this.paint("cells", colors, 0.45);
  }

  /** Colours each vertex by how far the field is from another one there. */
  paintDifference(difference: Difference): void {
    this.difference = difference;
    const { shares } = difference;
    const colors = new Uint8Array(3 * shares.length).fill(128);
    for (let v = 0; v < shares.length; v++) {
      if (Number.isNaN(shares[v])) continue;
      const entry = 4 * Math.round(shares[v] * (COLORMAP_SIZE - 1));
      colors.set(COLORMAP.subarray(entry, entry + 3), 3 * v);
    }
    this.paint("difference", colors, 0);
  }

  paintDistances(): void {
    this.painted = "distances";
    this.material.uniforms.painted.value = false;
    this.mesh.setAttribute("paint", undefined);
  }

  private paint(what: "cells" | "difference", colors: Uint8Array, shade: number): void {
    this.painted = what;
    this.material.uniforms.painted.value = true;
    this.material.uniforms.shade.value = shade;
    this.mesh.setAttribute("paint", new BufferAttribute(colors, 3, true));
  }

  /** The distance at a point in a face, as it is drawn; in the file's unit. */
  at(face: number, weights: Weights): number {
    const corners = this.mesh.cornersOf(face);
    // Squares of lengths in the file's unit may overflow.
    const unit = this.mesh.radius;
    const d = corners.map((vertex) => this.shownAt(vertex) / unit);
    let mean = 0;
    for (let i = 0; i < 3; i++) mean += weights[i] * (this.quadratic ? d[i] * d[i] : d[i]);
    if (!this.quadratic || !Number.isFinite(mean)) return mean * unit;
    const p = corners.map((vertex) => this.mesh.vertexPosition(vertex));
    for (let i = 0; i < 3; i++) {
      const j = (i + 1) % 3;
      const side = Math.hypot(p[i][0] - p[j][0], p[i][1] - p[j][1], p[i][2] - p[j][2]) / unit;
      mean -= weights[i] * weights[j] * side * side;
    }
    return Math.sqrt(Math.max(mean, 0)) * unit;
  }

  private shownAt(vertex: number): number {
    const distance = this.distances[vertex];
    return distance === Infinity && this.preview ? this.preview[vertex] : distance;
  }

  /** What the last colour stands for; 0 where colours stand for no number. */
  get scaleEnd(): number {
    return { distances: this.largest, cells: 0, difference: this.difference?.largest ?? 0 }[this.painted];
  }

  private setScale(): void {
    const { step, perLabel } = chooseIsolines(this.largest);
    this.material.uniforms.largest.value = Math.max(this.largest / this.mesh.radius, 1e-30);
    this.material.uniforms.lineStep.value = step / this.mesh.radius;
    this.material.uniforms.linesPerLabel.value = perLabel;
  }

  private setFront(front: number): void {
    this.material.uniforms.front.value = Number.isFinite(front) ? front : 1e10;
    this.material.uniforms.glow.value = Number.isFinite(front) ? 0.8 : 0;
  }
}
