// Geodesic distances, exact unless a tolerance is named, from one or many
// sources to every vertex and target.
//
//   absl::StatusOr<DistanceField> field =
//       Solve(*mesh, {.sources = {{VertexPoint{0}}}});
//
// To ask more about the same field, or to be asked whether to go on:
//
//   absl::StatusOr<ValidQuery> query =
//       ValidQuery::Make({.sources = {{VertexPoint{0}}}}, *mesh);
//   absl::StatusOr<DistanceField> field = Solve(*mesh, *query, {}, checkpoint);

#ifndef GEODESIC_SOLVE_H_
#define GEODESIC_SOLVE_H_

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/query.h"
#include "geodesic/solve_options.h"
#include "geodesic/valid_query.h"

namespace geodesic {

// Solves `query` on the whole of `mesh`.
//
// Guarantees:
//   1. exact: every distance is the length of a shortest path on the surface,
//      up to rounding. The relative error is below 1e-10, usually about 1e-15.
//      It is larger only for distances so short that one rounding of the mesh's
//      coordinates is a larger fraction of them; they are good to that
//      rounding. With a tolerance in the query, the relative error is at most
//      what the field certifies, and that is at most the tolerance;
//   2. +infinity exactly where no path leads;
//   3. deterministic: the same arguments give the same bits;
//   4. pure and thread-safe: no I/O, no shared state, and no threads unless
//      options.threads asks for them. The bits do not depend on the number of
//      threads.
//
// Errors: INVALID_ARGUMENT for an option out of range; INTERNAL if a vertex was
// left out beside one that was reached (a defect; another algorithm may find
// the answer); whatever `checkpoint` returns.
// Time: O(n^2 log n) at worst, in practice about n^1.5 on smooth meshes and
// less on rough ones. Memory beside the mesh: docs/algorithm.md.
absl::StatusOr<DistanceField> Solve(const Mesh& mesh, const ValidQuery& query,
                                    const SolveOptions& options,
                                    Checkpoint& checkpoint);

// The same for a query that is not yet valid.
// Errors: also those of ValidQuery::Make.
absl::StatusOr<DistanceField> Solve(const Mesh& mesh, const Query& query,
                                    const SolveOptions& options,
                                    Checkpoint& checkpoint);

// The same, and nothing stops it.
inline absl::StatusOr<DistanceField> Solve(const Mesh& mesh, const Query& query,
                                           const SolveOptions& options = {}) {
  NoCheckpoint checkpoint;
  return Solve(mesh, query, options, checkpoint);
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVE_H_
