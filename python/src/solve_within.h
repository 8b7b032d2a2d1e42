// A field up to a radius or to its targets, whatever the algorithm.

#ifndef GEODESIC_PYTHON_SOLVE_WITHIN_H_
#define GEODESIC_PYTHON_SOLVE_WITHIN_H_

#include <cstdint>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/computation.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/valid_query.h"

namespace geodesic::python {

// Distances beyond reach.radius, or beyond the last target that was waited for,
// are +infinity, as in a service's answer: also with algorithms that know
// nothing for certain before their end and so do not stop there. Errors: as
// Solve and Computation::Advance.
absl::StatusOr<DistanceField> SolveWithin(const Mesh& mesh,
                                          const ValidQuery& query,
                                          const Reach& reach, uint32_t threads,
                                          Checkpoint& checkpoint);

}  // namespace geodesic::python

#endif  // GEODESIC_PYTHON_SOLVE_WITHIN_H_
