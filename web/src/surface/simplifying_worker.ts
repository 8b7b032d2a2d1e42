// Simplifies a mesh beside the page, which goes on meanwhile.

import { MeshoptSimplifier } from "meshoptimizer/simplifier";

onmessage = async ({ data: { positions, indices, maxFaces } }) => {
  try {
    await MeshoptSimplifier.ready;
    // Colours are interpolated inside faces: needles would tell them wrongly.
    const [coarse] = MeshoptSimplifier.simplify(indices, positions, 3, 3 * maxFaces, 1, ["RegularizeLight"]);
    postMessage(coarse);
  } catch {
    postMessage(undefined);
  }
};
