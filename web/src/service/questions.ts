// The questions about distances, as streams of what the page shows.

import type { AnswerTrailer } from "../../generated/geodesic/v1/answer_pb";
import type { Algorithm } from "../../generated/geodesic/v1/query_pb";
import { FieldQuantity } from "../../generated/geodesic/v1/question_service_pb";
import type { Source } from "../surface/place";
import { readAnswer } from "./answer";
import { about, type Connection } from "./connection";
import { sourceOf } from "./points";

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
