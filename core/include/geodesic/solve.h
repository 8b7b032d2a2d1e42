// Exact geodesic distances from one or many sources to every vertex.
//
//   Query query{.sources = {{.vertex = 0}}};
//   NoCheckpoint checkpoint;
//   absl::StatusOr<DistanceField> field = Solve(*mesh, query, {}, checkpoint);

#ifndef GEODESIC_SOLVE_H_
#define GEODESIC_SOLVE_H_

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/query.h"

namespace geodesic {

// Parameters of FWP (Xu et al. 2015, Algorithm 1). They change the cost of an
// answer, never the answer.
struct SolveOptions {
  // Bucket width as a multiple of h / sqrt(n), with h the mean edge length and
  // n the number of faces. DEFAULT: 1, the paper's choice.
  double bucket_width = 1;
  // Bound on K, the number of windows an iteration propagates. DEFAULT: 2000.
  // The paper's 20000 takes whole wavefronts at once on meshes below a million
  // faces; smaller batches make fewer windows and let MMP forget sooner.
  uint32_t max_batch = 2000;
  // Whether K follows the wavefront (section 4.2). If not it is max_batch
  // throughout; 1 then drains the buckets one by one. DEFAULT: true.
  bool adaptive_batch = true;
};

// Solves `query` on `mesh`.
//
// Guarantees:
//   1. exact: every distance is the length of a shortest path on the surface,
//      up to rounding (relative error below 1e-10; about 1e-15 is usual;
//      distances so short that one rounding of the mesh's coordinates is a
//      larger fraction of them are good to that rounding);
//   2. +infinity exactly where no path leads;
//   3. deterministic: the same arguments give the same bits;
//   4. pure and thread-safe: no I/O, no threads, no shared state.
//
// Errors: INVALID_ARGUMENT as Validate; whatever `checkpoint` returns.
// Time: O(n^2 log n) at worst, in practice about n^1.5 on smooth meshes and
// less on rough ones. Memory beside the mesh: docs/algorithm.md.
absl::StatusOr<DistanceField> Solve(const Mesh& mesh, const Query& query,
                                    const SolveOptions& options,
                                    Checkpoint& checkpoint);

}  // namespace geodesic

#endif  // GEODESIC_SOLVE_H_
