// What `geodesic field -o field.html` puts into template/viewer.html in place of
// "GEODESIC_ANSWER": a JSON object. Arrays are base64 of little-endian numbers.

import type { MeshArrays } from "./surface/mesh";

interface Embedded {
  name: string;
  /** The mesh's digest. */
  digest: string;
  /** To be added to all positions. */
  center: [number, number, number];
  /** float32, x y z of each vertex. */
  positions: string;
  /** uint32, three vertices of each face. */
  faces: string;
  /** float64, one of each vertex. */
  distances: string;
  /** float64, x y z of each source that is a point; none if some are curves. */
  sources: string;
}

export interface EmbeddedAnswer {
  name: string;
  digest: string;
  arrays: MeshArrays;
  distances: Float64Array;
  /** x y z of each source that is a point, in the unit of the file. */
  sources: Float64Array;
}

export function readEmbedded(json: string): EmbeddedAnswer {
  const embedded = JSON.parse(json) as Embedded;
  const offsets = new Float32Array(bytes(embedded.positions));
  const positions = new Float64Array(offsets.length);
  for (let i = 0; i < offsets.length; i++) positions[i] = offsets[i] + embedded.center[i % 3];
  return {
    name: embedded.name,
    digest: embedded.digest,
    arrays: { positions, indices: new Uint32Array(bytes(embedded.faces)) },
    distances: new Float64Array(bytes(embedded.distances)),
    sources: new Float64Array(bytes(embedded.sources)),
  };
}

function bytes(base64: string): ArrayBuffer {
  const text = atob(base64);
  const array = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) array[i] = text.charCodeAt(i);
  return array.buffer;
}
