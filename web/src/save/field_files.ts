// A field as files, laid out as the command `geodesic field -o` writes them.

import type { MeshArrays } from "../surface/mesh";

/** NumPy's format: float64 (V,). */
export function npy(distances: Float64Array): BlobPart[] {
  const fields = `{'descr': '<f8', 'fortran_order': False, 'shape': (${distances.length},), }`;
  // Magic and length take 10 bytes; the whole head is a multiple of 64.
  const padded = fields.padEnd(Math.ceil((fields.length + 11) / 64) * 64 - 11) + "\n";
  const head = new Uint8Array(10 + padded.length);
  head.set([0x93, ...bytes("NUMPY"), 1, 0, padded.length & 255, padded.length >> 8]);
  head.set(bytes(padded), 10);
  return [head, distances as Float64Array<ArrayBuffer>];
}

/** A header line, then vertex and distance; numbers that read back the same. */
export function csv(distances: Float64Array): BlobPart[] {
  const lines = ["vertex,geodesic_distance"];
  distances.forEach((distance, vertex) => lines.push(`${vertex},${number(distance)}`));
  return [lines.join("\n"), "\n"];
}

/** The mesh with a scalar `geodesic_distance` at each vertex; binary. */
export function ply(mesh: MeshArrays, distances: Float64Array): BlobPart[] {
  const faces = mesh.indices.length / 3;
  const head = [
    "ply",
    "format binary_little_endian 1.0",
    `element vertex ${distances.length}`,
    ...["x", "y", "z", "geodesic_distance"].map((name) => `property double ${name}`),
    `element face ${faces}`,
    "property list uchar int vertex_indices",
    "end_header",
  ];
  const vertices = new Float64Array(4 * distances.length);
  for (let v = 0; v < distances.length; v++) {
    vertices.set(mesh.positions.subarray(3 * v, 3 * v + 3), 4 * v);
    vertices[4 * v + 3] = distances[v];
  }
  const list = new DataView(new ArrayBuffer(13 * faces));
  for (let face = 0; face < faces; face++) {
    list.setUint8(13 * face, 3);
    for (let k = 0; k < 3; k++) list.setUint32(13 * face + 1 + 4 * k, mesh.indices[3 * face + k], true);
  }
  return [head.join("\n") + "\n", vertices, list];
}

function number(value: number): string {
  return value === Infinity ? "inf" : String(value);
}

function bytes(text: string): Uint8Array {
  return new TextEncoder().encode(text);
}
