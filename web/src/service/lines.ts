// The questions whose answers are lines on the surface.

import type { Algorithm } from "../../generated/geodesic/v1/query_pb";
import type { LineQuestion, StraightLine } from "../surface/line_question";
import type { Place, Source } from "../surface/place";
import { readAnswer, type Arrays } from "./answer";
import { about, type Connection } from "./connection";
import { placesOf, pointOf, sourceOf } from "./points";

/** A shortest path from the source that is nearest to its target. */
export interface PathQuestion {
  sources: readonly Source[];
  target: Place;
  algorithm: Algorithm;
}

export interface SurfaceLine {
  /** That has this line for its answer, whatever the sources are by now. */
  question: LineQuestion;
  /** x y z of each point, in the unit of the file. */
  positions: Float64Array;
  places: Place[];
  length: number;
  /** Why it is shorter than was asked for, if it is. */
  ended?: "boundary" | "singular";
}

/** Whether it runs straight on; else it is a shortest path. */
export function isStraight({ question }: SurfaceLine): boolean {
  return "direction" in question;
}

/** The line; nothing if no path leads to the target. */
export async function askLine(
  connection: Connection,
  digest: string,
  question: PathQuestion | StraightLine,
  signal: AbortSignal,
): Promise<SurfaceLine | undefined> {
  return "direction" in question
    ? askStraightLine(connection, digest, question, signal)
    : askPath(connection, digest, question, signal);
}

async function askPath(
  connection: Connection,
  digest: string,
  { sources, target, algorithm }: PathQuestion,
  signal: AbortSignal,
): Promise<SurfaceLine | undefined> {
  const { arrays } = await readAnswer(connection.questions.computePaths(
    { meshDigest: digest, algorithm, sources: sources.map(sourceOf), targets: [pointOf(target)] },
    about(digest, signal),
  ));
  const line = lineOf(arrays);
  if (!line.places.length) return undefined;
  const source = sources[arrays.get("source", Uint32Array)[0]];
  return { ...line, question: { from: "curve" in source ? line.places[0] : source, target } };
}

async function askStraightLine(
  connection: Connection,
  digest: string,
  question: StraightLine,
  signal: AbortSignal,
): Promise<SurfaceLine> {
  const { from, direction, length } = question;
  const { arrays } = await readAnswer(connection.questions.traceLines(
    { meshDigest: digest, sources: [pointOf(from)], vectors: [...direction], lengths: [length] },
    about(digest, signal),
  ));
  const ended = ([undefined, "boundary", "singular"] as const)[arrays.get("end", Uint8Array)[0]];
  return { ...lineOf(arrays), question, ended };
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

// The one line of an answer.
function lineOf(arrays: Arrays): Omit<SurfaceLine, "question"> {
  return {
    positions: arrays.get("position", Float64Array),
    places: placesOf(arrays),
    length: arrays.get("length", Float64Array)[0],
  };
}
