// Brings a mesh here as the server holds it.

import type { MeshArrays } from "../surface/mesh";
import { about, type Connection } from "./connection";

/** `progress` gets shares from 0 to 1. */
export async function readMesh(
  connection: Connection,
  digest: string,
  progress: (share: number) => void,
  signal: AbortSignal,
): Promise<MeshArrays> {
  let positions = new Float64Array(0);
  let indices = new Uint32Array(0);
  let came = 0;
  for await (const { part } of connection.meshes.readMesh({ digest }, about(digest, signal))) {
    if (part.case === "header") {
      positions = new Float64Array(3 * Number(part.value.vertexCount));
      indices = new Uint32Array(3 * Number(part.value.faceCount));
    } else if (part.case === "vertices") {
      came += put(part.value.positions, positions, 3 * Number(part.value.firstVertex));
    } else if (part.case === "faces") {
      came += put(part.value.indices, indices, 3 * Number(part.value.firstFace));
    }
    progress(came / Math.max(positions.byteLength + indices.byteLength, 1));
  }
  return { positions, indices };
}

function put(bytes: Uint8Array, array: Float64Array | Uint32Array, first: number): number {
  new Uint8Array(array.buffer).set(bytes, first * array.BYTES_PER_ELEMENT);
  return bytes.length;
}
