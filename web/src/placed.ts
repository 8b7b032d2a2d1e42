// What the user has put on the mesh, which can be gone back to.

import type { SurfacePath } from "./service/questions";
import { sourceText, type Place, type Source } from "./surface/place";

/** A shortest path of its own: it stays when the sources are others. */
export interface KeptPath extends SurfacePath, PathEnds {}

export interface PathEnds {
  from: Place;
  target: Place;
}

export interface Sample {
  vertex: number;
  distance: number;
}

export interface Placed {
  readonly sources: readonly Source[];
  readonly paths: readonly KeptPath[];
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

/** The path that answers a question about these sources, with its own. */
export function keptPath(path: SurfacePath, sources: readonly Source[], target: Place): KeptPath {
  const source = sources[path.source];
  return { ...path, from: "curve" in source ? path.places[0] : source, target };
}

/** Whether one of the sources is this place. */
export function isSource(place: Place, sources: readonly Source[]): boolean {
  const text = sourceText(place);
  return sources.some((source) => sourceText(source) === text);
}
