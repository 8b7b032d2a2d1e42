#include "geodesic/rows/rows.h"

#include <utility>

namespace geodesic {

uint64_t DistanceRow::bytes() const {
  return columns.size() * sizeof(uint32_t) + values.size() * sizeof(double) +
         BytesOf(paths);
}

std::shared_ptr<const DistanceField> RowMeans::FindWhole(const SurfacePoint&) {
  return nullptr;
}

absl::StatusOr<TargetDistances> RowMeans::Search(const ValidQuery& query,
                                                 const Landmarks* landmarks,
                                                 Checkpoint& checkpoint) {
  TargetDistances answer;
  absl::Status status = WithSearch([&](TargetSearch& search) -> absl::Status {
    absl::StatusOr<TargetDistances> found =
        search.Run(query, landmarks, checkpoint);
    if (!found.ok()) return found.status();
    answer = *std::move(found);
    return absl::OkStatus();
  });
  if (!status.ok()) return status;
  if (TargetSearch::IsDirected(query->algorithm)) WantLandmarks();
  return answer;
}

}  // namespace geodesic
