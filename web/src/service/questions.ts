// The questions about distances, as streams of what the page shows.

import type { MessageInitShape } from "@bufbuild/protobuf";
import type { AnswerTrailer } from "../../generated/geodesic/v1/answer_pb";
import type { Algorithm } from "../../generated/geodesic/v1/query_pb";
import { FieldQuantity } from "../../generated/geodesic/v1/question_service_pb";
import type { SourceSchema } from "../../generated/geodesic/v1/surface_pb";
import type { Place, Source } from "../surface/place";
import { readAnswer, type Arrays } from "./answer";
import { about, type Connection } from "./connection";

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
  let from = 0;
  const { trailer } = await readAnswer(
    connection.questions.computeField(
      { ...shared(question), radius: question.radius, progressive: true },
      about(question.digest, signal),
    ),
    (arrays) => {
      const vertices = arrays.get("settled_vertex", Uint32Array, from);
      const distances = arrays.get("settled_distance", Float64Array, from).subarray(0, vertices.length);
      settled({ vertices: vertices.subarray(0, distances.length), distances });
      from += distances.length;
    },
  );
  return summaryOf(trailer);
}

/** The distance of every vertex, at once; +infinity where none is known. */
export async function askDistances(
  connection: Connection,
  question: FieldQuestion,
  signal: AbortSignal,
): Promise<{ distances: Float64Array; summary: FieldSummary }> {
  const { arrays, trailer } = await readAnswer(connection.questions.computeField(
    { ...shared(question), radius: question.radius, tolerance: question.tolerance },
    about(question.digest, signal),
  ));
  return { distances: arrays.get("distance", Float64Array), summary: summaryOf(trailer) };
}

/** The number of the nearest source at each vertex, 0xffffffff for none. */
export async function askCells(
  connection: Connection,
  question: FieldQuestion,
  signal: AbortSignal,
): Promise<Uint32Array> {
  const { arrays } = await readAnswer(connection.questions.computeField(
    { ...shared(question), radius: question.radius, quantities: [FieldQuantity.NEAREST_SOURCE] },
    about(question.digest, signal),
  ));
  return arrays.get("nearest_source", Uint32Array);
}

/** The shortest path to `target`; nothing if none leads there. */
export async function askPath(
  connection: Connection,
  question: FieldQuestion,
  target: Place,
  signal: AbortSignal,
): Promise<SurfacePath | undefined> {
  const { arrays } = await readAnswer(connection.questions.computePaths(
    { ...shared(question), targets: [pointOf(target)] },
    about(question.digest, signal),
  ));
  const places = placesOf(arrays);
  return places.length === 0 ? undefined : {
    positions: arrays.get("position", Float64Array),
    places,
    distance: arrays.get("distance", Float64Array)[0],
    length: arrays.get("length", Float64Array)[0],
    source: arrays.get("source", Uint32Array)[0],
  };
}

/** Vertices, each the farthest from the sources and from those before it. */
export async function askSamples(
  connection: Connection,
  question: FieldQuestion,
  count: number,
  signal: AbortSignal,
): Promise<{ vertex: number; distance: number }[]> {
  const { arrays } = await readAnswer(connection.questions.sampleFarthestPoints(
    { ...shared(question), count: BigInt(count) },
    about(question.digest, signal),
  ));
  const distances = arrays.get("distance", Float64Array);
  return Array.from(arrays.get("vertex", Uint32Array), (vertex, i) => ({ vertex, distance: distances[i] }));
}

/** A curve through the places in turn, by a shortest path from each to the next. */
export async function askCurve(
  connection: Connection,
  digest: string,
  through: readonly Place[],
  signal: AbortSignal,
): Promise<Place[]> {
  const pairs = through.slice(1).map((place, i) => ({ source: pointOf(through[i]), target: pointOf(place) }));
  const { arrays } = await readAnswer(connection.questions.computePairs(
    { meshDigest: digest, pairs, paths: true },
    about(digest, signal),
  ));
  const starts = new Set([0, ...Array.from(arrays.get("line_end", BigUint64Array), Number)]);
  if (starts.size <= pairs.length) throw new Error("No path leads along this curve.");
  // Each path begins where the one before it ended.
  return placesOf(arrays).filter((_, i) => i === 0 || !starts.has(i));
}

function summaryOf(trailer: AnswerTrailer): FieldSummary {
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

function placesOf(arrays: Arrays): Place[] {
  const numbers = arrays.get("point_numbers", Uint32Array);
  const weights = arrays.get("point_weights", Float64Array);
  return Array.from(arrays.get("point_kind", Uint8Array), (kind, i): Place => {
    const [first, second] = numbers.subarray(2 * i);
    const [a, b, c] = weights.subarray(3 * i);
    if (kind === 1) return { kind: "edge", from: first, to: second, t: a };
    if (kind === 2) return { kind: "face", face: first, weights: [a, b, c] };
    return { kind: "vertex", vertex: first };
  });
}
