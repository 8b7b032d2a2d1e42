// Parallel Chen-Han: exact like those of geodesic_types/algorithms.h, by levels
// in all threads and without a queue. It stands apart from these because
// neither its time nor its memory has a useful bound: it is here to compare
// with.
//
//   absl::StatusOr<DistanceField> field =
//       SolveByLevels(*mesh, query, {.threads = 8}, checkpoint);
//
// Ying, Xin, He: Parallel Chen-Han (PCH) algorithm for discrete geodesics. ACM
// TOG 33(1), 2014.

#ifndef GEODESIC_PARALLEL_CHEN_HAN_H_
#define GEODESIC_PARALLEL_CHEN_HAN_H_

#include <cstdint>
#include <limits>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/valid_query.h"

namespace geodesic {

// Parameters of parallel Chen-Han.
struct ParallelChenHanOptions {
  // How many threads share each level, in [1, kMostSolveThreads]; the calling
  // thread is one of them. The field is the same to the bit. DEFAULT: 1.
  uint32_t threads = 1;
  // The most memory beside the mesh. DEFAULT: no limit.
  uint64_t most_bytes = std::numeric_limits<uint64_t>::max();
};

// The field of the query's sources, as Solve gives it within rounding; its
// `algorithm` names the sequential order of the same windows, ch.
// Errors: INVALID_ARGUMENT for a number of threads out of range, and for what
// Chen and Han's rule does not take: curves, sources that are no vertices,
// meshes with faces without area or edges of three faces or more;
// RESOURCE_EXHAUSTED naming pch and its memory; whatever `checkpoint` returns.
absl::StatusOr<DistanceField> SolveByLevels(
    const Mesh& mesh, const ValidQuery& query,
    const ParallelChenHanOptions& options, Checkpoint& checkpoint);

}  // namespace geodesic

#endif  // GEODESIC_PARALLEL_CHEN_HAN_H_
