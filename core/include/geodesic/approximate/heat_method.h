// The heat method: heat that spreads for a short time flows away from its
// sources along shortest paths, and distances are what has those directions as
// its gradient.
//
//   auto heat = HeatMethod::Prepare(*mesh, {}, checkpoint);   // factorizes
//   absl::StatusOr<ApproximateField> field =                  // substitutes
//       (*heat)->Distances(query, checkpoint);
//
// Crane, Weischedel, Wardetzky: Geodesics in heat: a new approach to computing
// distance based on heat flow. ACM TOG 32(5), 2013.

#ifndef GEODESIC_APPROXIMATE_HEAT_METHOD_H_
#define GEODESIC_APPROXIMATE_HEAT_METHOD_H_

#include <cstdint>
#include <memory>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/approximate/prepared_method.h"
#include "geodesic/mesh.h"

namespace geodesic {

// Parameters of the heat method.
struct HeatOptions {
  // The time that heat spreads for is lambda h^2, with h the mean edge length.
  // More makes distances smoother; unequal edges want more (the paper's figure
  // 14). DEFAULT: 1, as in the literature.
  double lambda = MethodChoice().lambda;
  // Whether edges are turned inside the surface until they are those of an
  // intrinsic Delaunay triangulation. Without it, heat may become negative and
  // directions wrong where angles are obtuse. DEFAULT: true.
  bool intrinsic_delaunay = true;
};

// Guarantees:
//   1. +infinity exactly where no path leads, 0 at a source that is a vertex,
//      negative nowhere;
//   2. several sources on one component are pinned: each has distance 0,
//      however much heat flows between and around them.
//
// No heat flows across a boundary. Where the mesh has edges of three faces or
// faces that disagree in orientation, both systems are those of its tufted
// cover, with faces twice.
//
// Sources are points without offsets. One on a component of its own is where
// distances are 0 on average over the corners around it; of several, each that
// is no vertex pins the corners around it at their distance from it.
class HeatMethod final : public PreparedMethod {
 public:
  // Analyzes one matrix pattern and factorizes two matrices of it by CHOLMOD,
  // O(n^1.5) time and O(n log n) memory; `checkpoint` is asked between these
  // steps, of which each may take seconds on a million faces.
  // Errors: INVALID_ARGUMENT for a lambda that is not a finite number > 0;
  // FAILED_PRECONDITION if the heat matrix is not positive definite by
  // rounding; RESOURCE_EXHAUSTED; whatever `checkpoint` returns.
  static absl::StatusOr<std::shared_ptr<const HeatMethod>> Prepare(
      const Mesh& mesh, const HeatOptions& options, Checkpoint& checkpoint);

  // Errors: INVALID_ARGUMENT as Prepare, naming "lambda" (field_path.h).
  static absl::Status Check(const HeatOptions& options);

  HeatMethod(const HeatMethod&) = delete;
  HeatMethod& operator=(const HeatMethod&) = delete;
  ~HeatMethod() override;

  ApproximateMethod method() const override;
  uint64_t bytes() const override;

 private:
  // Two back-substitutions, O(n log n). Several sources on one component cost
  // another numeric factorization, and its memory for as long.
  // Errors: also INVALID_ARGUMENT for an offset; FAILED_PRECONDITION if heat
  // vanishes on the way, beyond some 1,300 square roots of its time from the
  // source: a larger lambda reaches farther; RESOURCE_EXHAUSTED.
  absl::StatusOr<std::vector<double>> Compute(
      const ValidQuery& query, Checkpoint& checkpoint) const override;

  class Systems;
  explicit HeatMethod(std::unique_ptr<const Systems> systems);

  std::unique_ptr<const Systems> systems_;
};

}  // namespace geodesic

#endif  // GEODESIC_APPROXIMATE_HEAT_METHOD_H_
