// What the user has put on the mesh, which can be gone back to.

import type { SurfaceLine } from "./service/lines";
import { sourceText, type Place, type Source } from "./surface/place";

export interface Sample {
  vertex: number;
  distance: number;
}

export interface Placed {
  readonly sources: readonly Source[];
  /** Shortest paths and lines that run straight on; they stay when the sources are others. */
  readonly paths: readonly SurfaceLine[];
  /** Those of the sources. */
  readonly samples: readonly Sample[];
  /** In the unit of the file; nothing for all. */
  readonly radius?: number;
}

export const NOTHING: Placed = { sources: [], paths: [], samples: [] };

export function isNothing({ sources, paths, samples, radius }: Placed): boolean {
  return !sources.length && !paths.length && !samples.length && radius === undefined;
}

export function areSame(a: readonly Source[], b: readonly Source[]): boolean {
  return a.length === b.length && a.every((source, i) => source === b[i]);
}

/** Whether one of the sources is this place. */
export function isSource(place: Place, sources: readonly Source[]): boolean {
  const text = sourceText(place);
  return sources.some((source) => sourceText(source) === text);
}
