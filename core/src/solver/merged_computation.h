// Within a tolerance where that ends, exactly where it does not.

#ifndef GEODESIC_SOLVER_MERGED_COMPUTATION_H_
#define GEODESIC_SOLVER_MERGED_COMPUTATION_H_

#include <memory>

#include "absl/functional/any_invocable.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/computation.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/valid_query.h"

namespace geodesic {

// Merged windows have no straight line by which to tell that they go round and
// round (winding.h). Where they become far more than those of any surface, what
// was asked is computed exactly, from the start.
class MergedComputation final : public Computation {
 public:
  // Starts the exact computation of a query.
  using StartExact =
      absl::AnyInvocable<absl::StatusOr<std::unique_ptr<Computation>>(
          const ValidQuery& query)>;

  // `merged` computes the query. The mesh outlives this.
  MergedComputation(const Mesh& mesh, const ValidQuery& query,
                    std::unique_ptr<Computation> merged,
                    StartExact start_exact);

  absl::Status Advance(const Reach& reach, Checkpoint& checkpoint) override;
  DistanceField Field() const override;
  absl::Status AddSource(const Source& source) override;
  uint64_t bytes() const override { return current_->bytes(); }

 private:
  absl::Status BeginExactly();

  const Mesh& mesh_;
  Query query_;  // with all sources that were added
  std::unique_ptr<Computation> current_;
  StartExact start_exact_;
  bool is_exact_ = false;
  SolveStatistics given_up_;  // of merged windows, once it is exact
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_MERGED_COMPUTATION_H_
