// Meshes whose distances are known: squares of a plane, where Euclid answers.

/** A square of side 1 in `n` by `n` squares, each of two triangles. */
export function planarGrid(n) {
  const positions = [];
  for (let j = 0; j <= n; ++j) {
    for (let i = 0; i <= n; ++i) positions.push([i / n, j / n, 0]);
  }
  const faces = [];
  for (let j = 0; j < n; ++j) {
    for (let i = 0; i < n; ++i) {
      const a = i + j * (n + 1);
      const b = a + n + 1;
      faces.push([a, a + 1, b + 1], [a, b + 1, b]);
    }
  }
  return { positions, faces };
}

/** The same with heights that make a solver work: no distances are known. */
export function bumpyGrid(n) {
  const { positions, faces } = planarGrid(n);
  const height = (x, y) =>
      0.05 * Math.sin(37 * x) * Math.cos(41 * y) + 0.01 * Math.sin(211 * x + 173 * y);
  return { positions: positions.map(([x, y]) => [x, y, height(x, y)]), faces };
}

/** The header and the bytes of an upload as MESH_FORMAT_ARRAYS. */
export function asArrays({ positions, faces }) {
  const bytes = Buffer.alloc(24 * positions.length + 12 * faces.length);
  let place = 0;
  for (const value of positions.flat()) place = bytes.writeDoubleLE(value, place);
  for (const value of faces.flat()) place = bytes.writeUInt32LE(value, place);
  const header = {
    format: 1,  // MESH_FORMAT_ARRAYS
    sizeBytes: BigInt(bytes.length),
    vertexCount: BigInt(positions.length),
    faceCount: BigInt(faces.length),
  };
  return { header, bytes };
}

export const distance = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));
