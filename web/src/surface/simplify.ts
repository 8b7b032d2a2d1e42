// Fewer faces over a mesh's own vertices, to be drawn instead of all.

/// <reference types="vite/client" />

import type { SurfaceMesh } from "./mesh";
import SimplifyingWorker from "./simplifying_worker?worker&inline";

/**
 * Three vertices of each face; more faces than `maxFaces` where the shape needs them.
 * Nothing if memory does not suffice, or the browser has no WebAssembly.
 */
export function simplify(mesh: SurfaceMesh, maxFaces: number, signal: AbortSignal): Promise<Uint32Array | undefined> {
  const worker = new SimplifyingWorker();
  const simplified = new Promise<Uint32Array | undefined>((resolve, reject) => {
    worker.onmessage = ({ data }) => resolve(data);
    worker.onerror = () => resolve(undefined);
    signal.addEventListener("abort", () => reject(signal.reason));
  });
  const { array: positions } = mesh.geometry.getAttribute("position");
  worker.postMessage({ positions, indices: mesh.arrays.indices, maxFaces });
  return simplified.finally(() => worker.terminate());
}
