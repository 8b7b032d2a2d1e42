#include "geodesic/rows/kept_searches.h"

#include <optional>
#include <utility>

#include "geodesic/computation.h"

namespace geodesic {

std::shared_ptr<const Landmarks> KeptSearches::landmarks() {
  const std::scoped_lock lock(mutex_);
  return landmarks_;
}

absl::StatusOr<bool> KeptSearches::MakeLandmarks(uint32_t count,
                                                 const SolveOptions& options,
                                                 Checkpoint& checkpoint) {
  {
    const std::scoped_lock lock(mutex_);
    if (landmarks_ != nullptr && landmarks_->HasEnough(count)) return true;
    if (are_being_made_) return false;
    are_being_made_ = true;
  }
  absl::StatusOr<Landmarks> made =
      geodesic::MakeLandmarks(mesh_, count, options, checkpoint);
  const std::scoped_lock lock(mutex_);
  are_being_made_ = false;
  if (!made.ok()) return made.status();
  landmarks_ = std::make_shared<const Landmarks>(*std::move(made));
  return true;
}

absl::Status KeptSearches::WithSearch(
    const std::function<absl::Status(TargetSearch&)>& work) {
  std::optional<TargetSearch> search;
  {
    const std::scoped_lock lock(mutex_);
    if (!idle_.empty()) {
      search.emplace(std::move(idle_.back()));
      idle_.pop_back();
    }
  }
  if (!search.has_value()) search.emplace(mesh_);
  absl::Status status = work(*search);
  // Not after an exception, which may leave the search half changed.
  const std::scoped_lock lock(mutex_);
  idle_.push_back(*std::move(search));
  return status;
}

absl::StatusOr<std::unique_ptr<Computation>> KeptSearches::Start(
    const ValidQuery& query) {
  return StartComputation(mesh_, query, options_);
}

}  // namespace geodesic
