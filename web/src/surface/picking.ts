// Finds the place of the surface under a ray.

import { DoubleSide, Raycaster, Triangle, Vector3, type Camera, type Vector2 } from "three";
import { MeshBVH } from "three-mesh-bvh";
import type { SurfaceMesh } from "./mesh";
import type { Place, Weights } from "./place";

export interface Hit {
  place: Extract<Place, { kind: "face" }>;
  /** On the screen's scale, as SurfaceMesh.toScreen gives it. */
  point: Vector3;
}

export class Picker {
  private readonly tree: MeshBVH;
  private readonly caster = new Raycaster();

  constructor(private readonly mesh: SurfaceMesh) {
    // Indirect: the faces keep their order, hence their numbers.
    this.tree = new MeshBVH(mesh.geometry, { indirect: true });
  }

  /** `pointer` is in normalized device coordinates, -1 to 1. */
  pick(pointer: Vector2, camera: Camera): Hit | undefined {
    this.caster.setFromCamera(pointer, camera);
    const hit = this.tree.raycastFirst(this.caster.ray, DoubleSide);
    if (hit?.faceIndex == null) return undefined;
    const face = hit.faceIndex;
    return { place: { kind: "face", face, weights: this.weightsAt(face, hit.point) }, point: hit.point };
  }

  private weightsAt(face: number, point: Vector3): Weights {
    const drawn = this.mesh.geometry.getAttribute("position");
    const corners = this.mesh.cornersOf(face).map((v) => new Vector3().fromBufferAttribute(drawn, v));
    const weights = new Vector3();
    // A face without area has no weights; its first corner will do.
    if (!Triangle.getBarycoord(point, corners[0], corners[1], corners[2], weights)) return [1, 0, 0];
    const bounded = weights.toArray().map((weight) => Math.max(weight, 0));
    const sum = bounded[0] + bounded[1] + bounded[2];
    return [bounded[0] / sum, bounded[1] / sum, bounded[2] / sum];
  }
}
