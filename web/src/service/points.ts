// Places and sources in messages of the protocol.

import type { MessageInitShape } from "@bufbuild/protobuf";
import type { SourceSchema } from "../../generated/geodesic/v1/surface_pb";
import type { Place, Source } from "../surface/place";
import type { Arrays } from "./answer";

interface PointInit {
  place:
    | { case: "vertex"; value: bigint }
    | { case: "edge"; value: { from: bigint; to: bigint; t: number } }
    | { case: "face"; value: { face: bigint; weights: number[] } };
}

export function pointOf(place: Place): PointInit {
  switch (place.kind) {
    case "vertex":
      return { place: { case: "vertex", value: BigInt(place.vertex) } };
    case "edge":
      return { place: { case: "edge", value: { from: BigInt(place.from), to: BigInt(place.to), t: place.t } } };
    case "face":
      return { place: { case: "face", value: { face: BigInt(place.face), weights: [...place.weights] } } };
  }
}

export function sourceOf(source: Source): MessageInitShape<typeof SourceSchema> {
  if ("curve" in source) {
    return { place: { case: "curve", value: { points: source.curve.map(pointOf) } } };
  }
  return { place: pointOf(source).place };
}

/** The points of the lines that an answer has. */
export function placesOf(arrays: Arrays): Place[] {
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
