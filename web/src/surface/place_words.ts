// Places and sources in words, for people.

import { formatNumber } from "../panel/format";
import type { SurfaceMesh } from "./mesh";
import type { Place, Source } from "./place";

/** Of more sources than these the rest is counted. */
const NAMED = 3;

/** "vertex 7", "a point in face 3". */
export function placeWords(place: Place): string {
  switch (place.kind) {
    case "vertex":
      return `vertex ${place.vertex}`;
    case "edge":
      return `a point on edge ${place.from}-${place.to}`;
    case "face":
      return `a point in face ${place.face}`;
  }
}

/** "vertex 7 (0, 0.5, 1)", "the nearest of 2 sources: vertex 7 (…), a curve of 12 points". */
export function sourcesWords(mesh: SurfaceMesh, sources: readonly Source[]): string {
  const words = sources.slice(0, NAMED).map((source) => {
    if ("curve" in source) return `a curve of ${source.curve.length} points`;
    return `${placeWords(source)} (${mesh.positionOf(source).map((x) => formatNumber(x, 4)).join(", ")})`;
  });
  if (sources.length > NAMED) words.push(`${sources.length - NAMED} more`);
  return sources.length === 1 ? words[0] : `the nearest of ${sources.length} sources: ${words.join(", ")}`;
}
