// The questions about distances, as streams of what the page shows.

import type { MessageInitShape } from "@bufbuild/protobuf";
import { FieldQuantity, type FieldTrailer } from "../../generated/geodesic/v1/field_service_pb";
import type { Algorithm } from "../../generated/geodesic/v1/query_pb";
import type { SourceSchema, SurfacePointSchema } from "../../generated/geodesic/v1/surface_pb";
import type { Place, Source } from "../surface/place";
import { about, type Connection } from "./connection";
import { float64From, uint32From } from "./numbers";

export interface FieldQuestion {
  digest: string;
  sources: readonly Source[];
  algorithm: Algorithm;
  radius?: number;
  /** The largest relative error that distances may have; nothing for exact ones. */
  tolerance?: number;
}

/** Vertices whose distances are final. */
export interface Settled {
  vertices: Uint32Array;
  distances: Float64Array;
}

export interface FieldSummary {
  /** Every distance up to here is there; +infinity if all are. */
  settledRadius: number;
  solveSeconds: number;
}

export interface SurfacePath {
  /** x y z of each point, in the unit of the file. */
  positions: Float64Array;
  places: Place[];
  distance: number;
  length: number;
  source: number;
}

/** Calls `settled` with the distances in order, as they become final. */
export async function askField(
  connection: Connection,
  question: FieldQuestion,
  settled: (part: Settled) => void,
  signal: AbortSignal,
): Promise<FieldSummary> {
  const stream = connection.fields.computeField(
    { ...shared(question), radius: question.radius, progressive: true },
    about(question.digest, signal),
  );
  let summary: FieldSummary | undefined;
  for await (const { part } of stream) {
    if (part.case === "settled") {
      settled({ vertices: uint32From(part.value.vertices), distances: float64From(part.value.distances) });
    } else if (part.case === "trailer") {
      summary = summaryOf(part.value);
    }
  }
  if (!summary) throw new Error("The answer broke off.");
  return summary;
}

/** The distance of every vertex, at once; +infinity where none is known. */
export async function askDistances(
  connection: Connection,
  question: FieldQuestion,
  vertexCount: number,
  signal: AbortSignal,
): Promise<{ distances: Float64Array; summary: FieldSummary }> {
  const distances = new Float64Array(vertexCount);
  let summary: FieldSummary | undefined;
  const stream = connection.fields.computeField(
    { ...shared(question), radius: question.radius, tolerance: question.tolerance },
    about(question.digest, signal),
  );
  for await (const { part } of stream) {
    if (part.case === "chunk") distances.set(float64From(part.value.distances), Number(part.value.offset));
    if (part.case === "trailer") summary = summaryOf(part.value);
  }
  if (!summary) throw new Error("The answer broke off.");
  return { distances, summary };
}

/** The number of the nearest source at each vertex, 0xffffffff for none. */
export async function askCells(
  connection: Connection,
  question: FieldQuestion,
  vertexCount: number,
  signal: AbortSignal,
): Promise<Uint32Array> {
  const cells = new Uint32Array(vertexCount);
  const stream = connection.fields.computeField(
    { ...shared(question), radius: question.radius, quantities: [FieldQuantity.NEAREST_SOURCE] },
    about(question.digest, signal),
  );
  for await (const { part } of stream) {
    if (part.case === "chunk") cells.set(uint32From(part.value.nearestSources), Number(part.value.offset));
  }
  return cells;
}

/** The shortest path to `target`; nothing if none leads there. */
export async function askPath(
  connection: Connection,
  question: FieldQuestion,
  target: Place,
  signal: AbortSignal,
): Promise<SurfacePath | undefined> {
  const stream = connection.paths.computePaths(
    { ...shared(question), targets: [pointOf(target)] },
    about(question.digest, signal),
  );
  let path: SurfacePath | undefined;
  for await (const { part } of stream) {
    if (part.case !== "path" || !part.value.piece || part.value.piece.pointCount === 0n) continue;
    const { piece, distance, length, source } = part.value;
    path ??= {
      positions: new Float64Array(3 * Number(piece.pointCount)),
      places: [],
      distance,
      length,
      source: Number(source ?? 0n),
    };
    path.positions.set(float64From(piece.positions), 3 * Number(piece.firstPoint));
    for (const point of piece.points) path.places.push(placeOf(point));
  }
  return path;
}

/** Vertices, each the farthest from the sources and from those before it. */
export async function askSamples(
  connection: Connection,
  question: FieldQuestion,
  count: number,
  signal: AbortSignal,
): Promise<{ vertex: number; distance: number }[]> {
  const samples: { vertex: number; distance: number }[] = [];
  const stream = connection.fields.sampleFarthestPoints(
    { ...shared(question), count: BigInt(count) },
    about(question.digest, signal),
  );
  for await (const { part } of stream) {
    if (part.case !== "samples") continue;
    for (const { vertex, distance } of part.value.samples) {
      samples.push({ vertex: Number(vertex), distance });
    }
  }
  return samples;
}

/** A curve through the places in turn, by a shortest path from each to the next. */
export async function askCurve(
  connection: Connection,
  digest: string,
  through: readonly Place[],
  signal: AbortSignal,
): Promise<{ places: Place[]; positions: Float64Array }> {
  const pairs = through.slice(1).map((place, i) => ({ source: pointOf(through[i]), target: pointOf(place) }));
  const places: Place[] = [];
  const positions: number[] = [];
  const stream = connection.pairs.computePairs({ meshDigest: digest, pairs, paths: true }, about(digest, signal));
  for await (const { part } of stream) {
    if (part.case !== "path" || !part.value.piece) continue;
    const { piece } = part.value;
    if (piece.pointCount === 0n) throw new Error("No path leads along this curve.");
    // Each path begins where the one before it ended.
    const skip = places.length > 0 && piece.firstPoint === 0n ? 1 : 0;
    for (const point of piece.points.slice(skip)) places.push(placeOf(point));
    positions.push(...float64From(piece.positions).subarray(3 * skip));
  }
  return { places, positions: new Float64Array(positions) };
}

function summaryOf(trailer: FieldTrailer): FieldSummary {
  return {
    settledRadius: trailer.settledRadius,
    solveSeconds: trailer.statistics?.solveSeconds ?? 0,
  };
}

function shared(question: FieldQuestion) {
  return {
    meshDigest: question.digest,
    algorithm: question.algorithm,
    sources: question.sources.map(sourceOf),
  };
}

function sourceOf(source: Source): MessageInitShape<typeof SourceSchema> {
  if ("curve" in source) {
    return { place: { case: "curve", value: { points: source.curve.map(pointOf) } } };
  }
  return { place: pointOf(source).place };
}

interface PointInit {
  place:
    | { case: "vertex"; value: bigint }
    | { case: "edge"; value: { from: bigint; to: bigint; t: number } }
    | { case: "face"; value: { face: bigint; weights: number[] } };
}

function pointOf(place: Place): PointInit {
  switch (place.kind) {
    case "vertex":
      return { place: { case: "vertex", value: BigInt(place.vertex) } };
    case "edge":
      return { place: { case: "edge", value: { from: BigInt(place.from), to: BigInt(place.to), t: place.t } } };
    case "face":
      return { place: { case: "face", value: { face: BigInt(place.face), weights: [...place.weights] } } };
  }
}

function placeOf(point: MessageInitShape<typeof SurfacePointSchema>): Place {
  const place = point.place;
  if (place?.case === "edge") {
    const { from, to, t } = place.value;
    return { kind: "edge", from: Number(from), to: Number(to), t: t ?? 0 };
  }
  if (place?.case === "face") {
    const [a, b, c] = place.value.weights ?? [];
    return { kind: "face", face: Number(place.value.face), weights: [a, b, c] };
  }
  return { kind: "vertex", vertex: Number(place?.value ?? 0) };
}
