// Farthest-point sampling.

#ifndef GEODESIC_SAMPLING_H_
#define GEODESIC_SAMPLING_H_

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"
#include "geodesic/solve_options.h"
#include "geodesic/valid_query.h"

namespace geodesic {

// A sample, and how far it is from those before it.
struct FarthestSample {
  uint32_t vertex = 0;
  // Its distance from the sources and all earlier samples, in the unit of the
  // file; +infinity for the first one on a component of its own.
  double distance = 0;
};

// Returns `count` vertices, each the farthest from the query's sources and from
// all samples before it. Among vertices that tie up to rounding it takes the
// lowest number. There are fewer if every vertex is at distance 0 already.
// Components without a source come first. Vertices without a face are left out.
// With a tolerance in the query, both "farthest" and the distances hold within
// it.
// The query's targets and trace are not used.
//
// One computation goes on with every sample. A sample costs O(V) and the
// propagation over about the area that it takes over. At each sample
// `checkpoint` sees the settled radius start from 0 again.
// Errors: whatever `checkpoint` returns. Thread-safe.
absl::StatusOr<std::vector<FarthestSample>> SampleFarthestPoints(
    const Mesh& mesh, const ValidQuery& query, uint32_t count,
    const SolveOptions& options, Checkpoint& checkpoint);

}  // namespace geodesic

#endif  // GEODESIC_SAMPLING_H_
