// Paths as files, laid out as the command `geodesic path -o` writes them.

import type { SurfaceLine } from "../service/lines";

/** Wavefront OBJ: the points of each path, and an `l` statement. */
export function pathsObj(paths: readonly SurfaceLine[]): BlobPart[] {
  const lines: string[] = [];
  let first = 1;
  paths.forEach((path, i) => {
    const count = path.positions.length / 3;
    lines.push(`g path_${i}`);
    for (let p = 0; p < count; p++) lines.push(`v ${path.positions.subarray(3 * p, 3 * p + 3).join(" ")}`);
    lines.push(`l ${Array.from({ length: count }, (_, p) => first + p).join(" ")}`);
    first += count;
  });
  return [lines.join("\n"), "\n"];
}
