// Which fields are shown nearly right until they are there exactly: those of
// large meshes that the server computes much sooner within a tolerance.

import { Algorithm } from "../../generated/geodesic/v1/query_pb";
import type { FieldQuestion } from "../service/questions";
import type { SurfaceMesh } from "./mesh";

/** The largest relative error of what is shown meanwhile. */
export const PREVIEW_TOLERANCE = 1e-3;
/** In words. */
export const PREVIEW_WORDS = "within 0.1 %";

/** Fields of smaller meshes take less time than the front that shows them. */
const LARGE = 300_000;

export function takesPreview(mesh: SurfaceMesh, question: FieldQuestion): boolean {
  // Whatever the tolerance, the server answers exactly, and no sooner, for curves and
  // several sources off the vertices; other algorithms take no tolerance.
  const { algorithm, sources } = question;
  const takesTolerance = algorithm === Algorithm.UNSPECIFIED || algorithm === Algorithm.FWP_LIST;
  const arePoints = sources.every((source) => !("curve" in source));
  const areVertices = arePoints && sources.every((source) => "kind" in source && source.kind === "vertex");
  return mesh.faceCount > LARGE && takesTolerance && (areVertices || (arePoints && sources.length === 1));
}
