// What approximate methods start from: vertices whose distances the sources
// give.

#ifndef GEODESIC_APPROXIMATE_SEEDS_H_
#define GEODESIC_APPROXIMATE_SEEDS_H_

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"
#include "geodesic/valid_query.h"
#include "geodesic_types/algorithms.h"

namespace geodesic {

// No distance is larger, in the mesh's scaled unit.
struct Seed {
  uint32_t vertex;
  double distance;
};

// A seed for each vertex that is a source or a corner of a face around one, in
// the order of vertices.
// Errors: INVALID_ARGUMENT naming what no approximate method does: curves,
// targets, a trace; whatever `checkpoint` returns.
absl::StatusOr<std::vector<Seed>> SeedsOf(const ValidQuery& query,
                                          const Mesh& mesh,
                                          ApproximateMethod method,
                                          Checkpoint& checkpoint);

}  // namespace geodesic

#endif  // GEODESIC_APPROXIMATE_SEEDS_H_
