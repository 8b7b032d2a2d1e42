// Arrays of numbers from `bytes` fields, which are little endian as all
// processors are on which browsers run.

/** Copies, since the bytes of a message begin anywhere. */
export function float64From(bytes: Uint8Array): Float64Array {
  return new Float64Array(bytes.slice().buffer);
}

/** Copies, since the bytes of a message begin anywhere. */
export function uint32From(bytes: Uint8Array): Uint32Array {
  return new Uint32Array(bytes.slice().buffer);
}
