// Places on the surface, and their spelling in commands and in Python.

export type Weights = readonly [number, number, number];

export type Place =
  | { kind: "vertex"; vertex: number }
  | { kind: "edge"; from: number; to: number; t: number }
  | { kind: "face"; face: number; weights: Weights };

/** What distances are measured from: a place, or every point of a curve. */
export type Source = Place | { curve: Place[] };

/** As `geodesic` takes it after --source. */
export function commandText(place: Place): string {
  switch (place.kind) {
    case "vertex":
      return `${place.vertex}`;
    case "edge":
      return `edge:${place.from}-${place.to}@${place.t}`;
    case "face":
      return `face:${place.face}@${place.weights.join(",")}`;
  }
}

/** As `geodesic` takes it after --source, or after --curve. */
export function sourceText(source: Source): string {
  return "curve" in source ? source.curve.map(commandText).join(";") : commandText(source);
}

export function pythonText(place: Place): string {
  switch (place.kind) {
    case "vertex":
      return `${place.vertex}`;
    case "edge":
      return `geodesic.EdgePoint(${place.from}, ${place.to}, ${place.t})`;
    case "face":
      return `geodesic.FacePoint(${place.face}, (${place.weights.join(", ")}))`;
  }
}

/** The source that `sourceText` wrote; nothing if it is none. */
export function parseSource(text: string): Source | undefined {
  const places = text.split(";").map(parsePlace).filter((place) => place !== undefined);
  if (places.length < text.split(";").length) return undefined;
  return places.length > 1 ? { curve: places } : places[0];
}

/** The place that `commandText` wrote; nothing if it is none. */
export function parsePlace(text: string): Place | undefined {
  if (/^\d+$/.test(text)) return { kind: "vertex", vertex: Number(text) };
  const edge = /^edge:(\d+)-(\d+)@([\d.e+-]+)$/.exec(text);
  if (edge) return { kind: "edge", from: Number(edge[1]), to: Number(edge[2]), t: Number(edge[3]) };
  const face = /^face:(\d+)@([\d.e+-]+),([\d.e+-]+),([\d.e+-]+)$/.exec(text);
  if (!face) return undefined;
  return { kind: "face", face: Number(face[1]), weights: [Number(face[2]), Number(face[3]), Number(face[4])] };
}
