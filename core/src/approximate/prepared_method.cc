#include "geodesic/approximate/prepared_method.h"

#include <chrono>
#include <utility>

namespace geodesic {

absl::StatusOr<ApproximateField> PreparedMethod::Distances(
    const ValidQuery& query, Checkpoint& checkpoint) const {
  const auto start = std::chrono::steady_clock::now();
  absl::StatusOr<std::vector<double>> distances = Compute(query, checkpoint);
  if (!distances.ok()) return distances.status();
  mesh().SpreadToJoined(*distances);
  return ApproximateField{
      .distances = *std::move(distances),
      .method = method(),
      .solve_seconds = std::chrono::duration<double>(
                           std::chrono::steady_clock::now() - start)
                           .count()};
}

}  // namespace geodesic
