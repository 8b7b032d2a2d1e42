// The lines of an OBJ file that the page saved.

/** Of each line its points, x y z. */
export function linesIn(obj) {
  const rows = (kind) => [...obj.matchAll(new RegExp(`^${kind} (.*)$`, "gm"))].map(([, row]) => row.split(" ").map(Number));
  const points = rows("v");
  return rows("l").map((line) => line.map((number) => points[number - 1]));
}

export function lengthOf(points) {
  return points.slice(1).reduce((sum, point, i) => sum + Math.hypot(...point.map((x, k) => x - points[i][k])), 0);
}
