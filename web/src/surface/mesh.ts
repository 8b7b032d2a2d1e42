// A mesh as it is drawn and picked: the file's exact coordinates beside those
// of the screen, which are moved to the origin and scaled to a ball of radius 1.
// A large one also has a coarse list of faces over the same vertices, which is
// drawn while the picture changes; all else is about the faces of the file.

import { BufferAttribute, BufferGeometry, Vector3 } from "three";
import type { LineQuestion } from "./line_question";
import type { Place, Source } from "./place";
import { vertexNormals } from "./vertex_normals";

export interface MeshArrays {
  /** x y z of each vertex, in the unit of the file. */
  positions: Float64Array;
  /** Three vertices of each face. */
  indices: Uint32Array;
}

/** On the screen's scale; lines have less, by rounding. */
const VISIBLE_AREA = 1e-6;

export type Vector = [number, number, number];

export class SurfaceMesh {
  readonly vertexCount: number;
  readonly faceCount: number;
  readonly geometry: BufferGeometry;
  /** Fewer faces, with the attributes of `geometry`; nothing if there are none. */
  coarse: BufferGeometry | undefined;
  /** What the view shows at first: vertices of faces, on the screen's scale. */
  readonly framed: Float32Array;
  /** Whether the file of its name, read as any, is this mesh. */
  isFile = false;
  /** Whether a coarse list is on its way. */
  awaitsCoarse = false;
  readonly center: Vector;
  /** Half the diagonal of the bounding box of all faces, in the unit of the file. */
  readonly radius: number;

  constructor(
    readonly arrays: MeshArrays,
    readonly digest: string,
    readonly name: string,
  ) {
    this.vertexCount = arrays.positions.length / 3;
    this.faceCount = arrays.indices.length / 3;
    const ofFaces = positionsOfFaces(arrays);
    const { low, high } = boundingBox(ofFaces);
    this.center = [0, 1, 2].map((i) => (low[i] + high[i]) / 2) as Vector;
    this.radius = Math.hypot(...[0, 1, 2].map((i) => (high[i] - low[i]) / 2)) || 1;
    const drawn = this.toScreen(arrays.positions);
    this.framed = ofFaces === arrays.positions ? drawn : this.toScreen(ofFaces);
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute("position", new BufferAttribute(drawn, 3));
    this.geometry.setAttribute("normal", new BufferAttribute(vertexNormals(drawn, arrays.indices), 3));
    this.geometry.setIndex(new BufferAttribute(arrays.indices, 1));
  }

  /** Three vertices of each face of a coarse list. */
  setCoarse(indices: Uint32Array): void {
    this.coarse?.dispose();
    this.coarse = new BufferGeometry();
    for (const [name, attribute] of Object.entries(this.geometry.attributes)) this.coarse.setAttribute(name, attribute);
    this.coarse.setIndex(new BufferAttribute(indices, 1));
  }

  /** Sets what is drawn of each vertex; nothing takes it away. */
  setAttribute(name: string, attribute: BufferAttribute | undefined): void {
    for (const geometry of [this.geometry, this.coarse]) {
      if (attribute) geometry?.setAttribute(name, attribute);
      else geometry?.deleteAttribute(name);
    }
  }

  /** Points of the file as they are drawn. */
  toScreen(points: Float64Array): Float32Array {
    const drawn = new Float32Array(points.length);
    for (let i = 0; i < points.length; i += 3) {
      for (let k = 0; k < 3; k++) drawn[i + k] = (points[i + k] - this.center[k]) / this.radius;
    }
    return drawn;
  }

  /** Whether there is something to see. */
  get hasArea(): boolean {
    const drawn = this.geometry.getAttribute("position");
    const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
    let area = 0;
    for (let face = 0; face < this.faceCount; face++) {
      [a, b, c].forEach((corner, i) => corner.fromBufferAttribute(drawn, this.arrays.indices[3 * face + i]));
      area += b.sub(a).cross(c.sub(a)).length() / 2;
      if (area > VISIBLE_AREA) return true;
    }
    return false;
  }

  cornersOf(face: number): Vector {
    const { indices } = this.arrays;
    return [indices[3 * face], indices[3 * face + 1], indices[3 * face + 2]];
  }

  vertexPosition(vertex: number): Vector {
    const { positions } = this.arrays;
    return [positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]];
  }

  /** In the unit of the file. */
  positionOf(place: Place): Vector {
    return this.weighted(place).reduce<Vector>(
      (sum, [vertex, weight]) => {
        const p = this.vertexPosition(vertex);
        return [sum[0] + weight * p[0], sum[1] + weight * p[1], sum[2] + weight * p[2]];
      },
      [0, 0, 0],
    );
  }

  /** The vertex with the greatest weight in a place. */
  nearestCorner(place: Place): number {
    return this.weighted(place).reduce((best, corner) => (corner[1] > best[1] ? corner : best))[0];
  }

  /** Whether the mesh has this place. */
  holds(place: Place): boolean {
    if (place.kind === "face") return place.face < this.faceCount;
    return this.weighted(place).every(([vertex]) => vertex < this.vertexCount);
  }

  /** Whether the mesh has every place of a source. */
  holdsSource(source: Source): boolean {
    return "curve" in source ? source.curve.every((place) => this.holds(place)) : this.holds(source);
  }

  /** Whether the mesh has the places that a line is asked by. */
  holdsLine(line: LineQuestion): boolean {
    return this.holds(line.from) && (!("target" in line) || this.holds(line.target));
  }

  private weighted(place: Place): [number, number][] {
    if (place.kind === "vertex") return [[place.vertex, 1]];
    if (place.kind === "edge") return [[place.from, 1 - place.t], [place.to, place.t]];
    return this.cornersOf(place.face).map((vertex, i) => [vertex, place.weights[i]]);
  }

  dispose(): void {
    this.geometry.dispose();
    this.coarse?.dispose();
  }
}

// The vertices that are corners of faces, or all if there is no face.
function positionsOfFaces({ positions, indices }: MeshArrays): Float64Array {
  const isCorner = new Uint8Array(positions.length / 3);
  for (const vertex of indices) isCorner[vertex] = 1;
  const count = isCorner.reduce((sum, bit) => sum + bit, 0);
  if (count === 0 || count === isCorner.length) return positions;
  const corners = new Float64Array(3 * count);
  let end = 0;
  isCorner.forEach((bit, vertex) => {
    if (!bit) return;
    corners.set(positions.subarray(3 * vertex, 3 * vertex + 3), end);
    end += 3;
  });
  return corners;
}

function boundingBox(positions: Float64Array): { low: Vector; high: Vector } {
  const low: Vector = [Infinity, Infinity, Infinity];
  const high: Vector = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3) {
    for (let k = 0; k < 3; k++) {
      const value = positions[i + k];
      if (value < low[k]) low[k] = value;
      if (value > high[k]) high[k] = value;
    }
  }
  return positions.length ? { low, high } : { low: [0, 0, 0], high: [0, 0, 0] };
}
