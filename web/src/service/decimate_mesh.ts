// Fewer faces over a mesh's own vertices, to be drawn instead of all.

import { about, type Connection } from "./connection";
import { uint32From } from "./numbers";

/** Three vertices of each face; more faces than `maxFaces` where the shape needs them. */
export async function decimateMesh(
  connection: Connection,
  digest: string,
  maxFaces: number,
  signal: AbortSignal,
): Promise<Uint32Array> {
  let indices = new Uint32Array(0);
  const stream = connection.meshes.decimateMesh({ digest, maxFaces: BigInt(maxFaces) }, about(digest, signal));
  for await (const { part } of stream) {
    if (part.case === "header") indices = new Uint32Array(3 * Number(part.value.faceCount));
    else if (part.case === "faces") indices.set(uint32From(part.value.indices), 3 * Number(part.value.firstFace));
  }
  return indices;
}
