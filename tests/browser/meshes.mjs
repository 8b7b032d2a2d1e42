// Meshes as files, and where those outside the project are.

import { existsSync } from "node:fs";
import { join } from "node:path";

/** How far the surface of a rough ball is from the middle, in a direction. */
export function roughRadius(x, y, z) {
  return 1 + 0.02 * Math.sin(37 * x) * Math.cos(41 * y) * Math.sin(29 * z) +
    0.003 * Math.sin(311 * x + 173 * y + 97 * z);
}

/** A sphere in OBJ: an octahedron whose faces are cut into n * n. */
export function sphereObj(n, radius = () => 1) {
  const numbers = new Map();
  const lines = [];
  const vertex = (p) => {
    const length = Math.hypot(...p);
    const direction = p.map((x) => x / length);
    const line = `v ${direction.map((x) => x * radius(...direction)).join(" ")}`;
    if (!numbers.has(line)) {
      lines.push(line);
      numbers.set(line, numbers.size + 1);
    }
    return numbers.get(line);
  };
  const faces = [];
  for (const x of [1, -1]) for (const y of [1, -1]) for (const z of [1, -1]) {
    const corner = (i, j) => vertex([x * i + 0, y * j + 0, z * (n - i - j) + 0]);
    const face = (a, b, c) => faces.push(x * y * z > 0 ? `f ${a} ${b} ${c}` : `f ${a} ${c} ${b}`);
    for (let i = 0; i < n; i++) for (let j = 0; i + j < n; j++) {
      face(corner(i, j), corner(i + 1, j), corner(i, j + 1));
      if (i + j + 1 < n) face(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
    }
  }
  return [...lines, ...faces, ""].join("\n");
}

/** A grid of 2 * n by 2 * n squares in OBJ, each cut in two; the plane is from -width to width and from -height to height. */
export function planeObj(n, width, height) {
  const lines = [];
  const count = 2 * n + 1;
  for (let j = 0; j < count; j++) for (let i = 0; i < count; i++) lines.push(`v ${(width * (i - n)) / n} ${(height * (j - n)) / n} 0`);
  for (let j = 0; j + 1 < count; j++) for (let i = 0; i + 1 < count; i++) {
    const corner = j * count + i + 1;
    lines.push(`f ${corner} ${corner + 1} ${corner + count + 1}`, `f ${corner} ${corner + count + 1} ${corner + count}`);
  }
  return [...lines, ""].join("\n");
}

/** Two squares that do not touch, side by side, in OFF. */
export const TWO_SQUARES = `OFF
8 4 0
-1.2 -0.5 0
-0.2 -0.5 0
-0.2 0.5 0
-1.2 0.5 0
0.2 -0.5 0
1.2 -0.5 0
1.2 0.5 0
0.2 0.5 0
3 0 1 2
3 0 2 3
3 4 5 6
3 4 6 7
`;

/** The same in VTK's XML format. */
export const TWO_SQUARES_VTP = `<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian">
<PolyData><Piece NumberOfPoints="8" NumberOfPolys="4">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
${TWO_SQUARES.split("\n").slice(2, 10).join("\n")}
</DataArray></Points>
<Polys>
<DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 0 2 3 4 5 6 4 6 7</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">3 6 9 12</DataArray>
</Polys>
</Piece></PolyData></VTKFile>
`;

/** The path of a mesh outside the project; nothing if it is not there. */
export function outsideMesh(name) {
  const path = join(process.env.GEODESIC_TEST_MESHES ?? "", name);
  return existsSync(path) ? path : undefined;
}
