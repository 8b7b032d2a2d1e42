// Chooses how a mesh is looked at first.

import { Vector2, Vector3 } from "three";

/**
 * z for a mesh that is flat along z, as terrains are, or that would stand
 * upright along z but not along y. Otherwise y, as in most models. The same
 * choice as in the pictures of the command `geodesic`.
 */
function guessUp(positions: Float32Array): "y" | "z" {
  const [x, y, z] = [0, 1, 2].map((axis) => extent(positions, axis));
  if (z.size < 0.4 * Math.min(x.size, y.size)) return "z";
  return standsOn(2, positions) && !standsOn(1, positions) ? "z" : "y";
}

export interface View {
  up: Vector3;
  /** From the middle of the mesh to the viewer; a unit vector. */
  direction: Vector3;
  /** Half of what is seen, to the right and up, on the screen's scale. */
  halfSize: Vector2;
}

/**
 * The oblique view, of some from all around, in which the mesh is largest.
 * `positions` are on the screen's scale.
 */
export function firstView(positions: Float32Array): View {
  const up = guessUp(positions);
  const elevation = ((up === "z" ? 38 : 16) * Math.PI) / 180;
  const views = Array.from({ length: 8 }, (_, i) => {
    const azimuth = ((30 + 45 * i) * Math.PI) / 180;
    const level = new Vector3(Math.sin(azimuth), 0, Math.cos(azimuth)).multiplyScalar(Math.cos(elevation));
    return up === "y"
      ? viewFrom(level.setY(Math.sin(elevation)), new Vector3(0, 1, 0), positions)
      : viewFrom(new Vector3(level.x, -level.z, Math.sin(elevation)), new Vector3(0, 0, 1), positions);
  });
  // The first one, from the front, unless another is larger for certain.
  return views.reduce((best, view) => (area(view) > 1.01 * area(best) ? view : best));
}

function area({ halfSize }: View): number {
  return halfSize.x * halfSize.y;
}

function viewFrom(direction: Vector3, up: Vector3, positions: Float32Array): View {
  const right = up.clone().cross(direction).normalize();
  const above = direction.clone().cross(right);
  const halfSize = new Vector2();
  // Some thousand vertices show how wide it is.
  const stride = 3 * Math.ceil(positions.length / 15000);
  for (let i = 0; i < positions.length; i += stride) {
    const point = new Vector3(positions[i], positions[i + 1], positions[i + 2]);
    halfSize.x = Math.max(halfSize.x, Math.abs(point.dot(right)));
    halfSize.y = Math.max(halfSize.y, Math.abs(point.dot(above)));
  }
  return { up, direction, halfSize };
}

function extent(positions: Float32Array, axis: number): { low: number; size: number } {
  let low = Infinity;
  let high = -Infinity;
  for (let i = axis; i < positions.length; i += 3) {
    low = Math.min(low, positions[i]);
    high = Math.max(high, positions[i]);
  }
  return { low, size: high - low };
}

// Whether the middle is above the box around the points that touch the ground.
function standsOn(up: number, positions: Float32Array): boolean {
  const { low, size } = extent(positions, up);
  const ground = low + 0.03 * size;
  return [(up + 1) % 3, (up + 2) % 3].every((axis) => {
    let sum = 0;
    let left = Infinity;
    let right = -Infinity;
    for (let i = 0; i < positions.length; i += 3) {
      sum += positions[i + axis];
      if (positions[i + up] > ground) continue;
      left = Math.min(left, positions[i + axis]);
      right = Math.max(right, positions[i + axis]);
    }
    const middle = (3 * sum) / positions.length;
    return middle >= left && middle <= right;
  });
}
