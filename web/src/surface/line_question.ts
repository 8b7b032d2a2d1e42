// What a line on the surface is asked by, and its spelling in the page's address.

import type { Vector } from "./mesh";
import { commandText, parsePlace, sourceText, type Place } from "./place";

/** A line between two places, as short as any. */
export interface PathEnds {
  from: Place;
  target: Place;
}

/** A line that runs straight on. */
export interface StraightLine {
  from: Place;
  /** In space, of any length: the line starts in the direction of the surface nearest to it. */
  direction: Vector;
  /** In the unit of the file; a boundary may end the line before. */
  length: number;
}

export type LineQuestion = PathEnds | StraightLine;

/** A path as a curve of two places is written; of a line, where it leads is "straight:X,Y,Z@LENGTH". */
export function lineText(line: LineQuestion): string {
  if ("target" in line) return sourceText({ curve: [line.from, line.target] });
  return `${commandText(line.from)};straight:${line.direction.join(",")}@${line.length}`;
}

/** The question that `lineText` wrote; nothing if it is none. */
export function parseLine(text: string): LineQuestion | undefined {
  const [first, second, ...more] = text.split(";");
  const from = parsePlace(first);
  if (!from || second === undefined || more.length) return undefined;
  const straight = /^straight:([\d.e+-]+),([\d.e+-]+),([\d.e+-]+)@([\d.e+-]+)$/.exec(second);
  if (straight) {
    const [x, y, z, length] = straight.slice(1).map(Number);
    const isLine = [x, y, z, length].every(Number.isFinite) && length > 0;
    return isLine ? { from, direction: [x, y, z], length } : undefined;
  }
  const target = parsePlace(second);
  return target && { from, target };
}
