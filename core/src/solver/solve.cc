#include "geodesic/solve.h"

#include "geodesic/computation.h"

namespace geodesic {

absl::StatusOr<DistanceField> Solve(const Mesh& mesh, const ValidQuery& query,
                                    const SolveOptions& options,
                                    Checkpoint& checkpoint) {
  absl::StatusOr<std::unique_ptr<Computation>> computation =
      StartComputation(mesh, query, options);
  if (!computation.ok()) return computation.status();
  if (absl::Status status = (*computation)->Advance({}, checkpoint);
      !status.ok()) {
    return status;
  }
  return (*computation)->Field();
}

absl::StatusOr<DistanceField> Solve(const Mesh& mesh, const Query& query,
                                    const SolveOptions& options,
                                    Checkpoint& checkpoint) {
  const absl::StatusOr<ValidQuery> valid = ValidQuery::Make(query, mesh);
  if (!valid.ok()) return valid.status();
  return Solve(mesh, *valid, options, checkpoint);
}

}  // namespace geodesic
