// Prepares any approximate method by its place in the list (algorithms.h).

#ifndef GEODESIC_APPROXIMATE_PREPARE_H_
#define GEODESIC_APPROXIMATE_PREPARE_H_

#include <cstdint>
#include <memory>

#include "absl/status/statusor.h"
#include "geodesic/approximate/heat_method.h"
#include "geodesic/approximate/prepared_method.h"
#include "geodesic/approximate/saddle_vertex_graph.h"
#include "geodesic/approximate/triangle_unfolding.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"
#include "geodesic_types/algorithms.h"

namespace geodesic {

// What methods can be told; each reads its own part.
struct MethodOptions {
  HeatOptions heat;
  SaddleGraphOptions svg;
  TriangleUnfoldingOptions gtu;
};

// Errors: INVALID_ARGUMENT for a parameter of the method that is out of range,
// by its name ("lambda", "neighbours", "samples": field_path.h).
absl::Status Validate(const MethodChoice& choice);

// Prepares the choice, with so many threads where the method takes them.
// Errors: as the method's own Prepare.
absl::StatusOr<std::shared_ptr<const PreparedMethod>> PrepareMethod(
    const Mesh& mesh, const MethodChoice& choice, uint32_t threads,
    Checkpoint& checkpoint);

// Errors: as the method's own Prepare.
absl::StatusOr<std::shared_ptr<const PreparedMethod>> PrepareMethod(
    const Mesh& mesh, ApproximateMethod method, const MethodOptions& options,
    Checkpoint& checkpoint);

}  // namespace geodesic

#endif  // GEODESIC_APPROXIMATE_PREPARE_H_
