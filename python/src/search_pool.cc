#include "search_pool.h"

#include <utility>

namespace geodesic::python {

absl::StatusOr<TargetDistances> SearchPool::Run(const ValidQuery& query,
                                                Checkpoint& checkpoint) {
  std::unique_ptr<TargetSearch> search;
  std::shared_ptr<const Landmarks> landmarks;
  {
    const std::scoped_lock lock(mutex_);
    landmarks = landmarks_;
    if (!idle_.empty()) {
      search = std::move(idle_.back());
      idle_.pop_back();
    }
  }
  if (search == nullptr) search = std::make_unique<TargetSearch>(mesh_);
  absl::StatusOr<TargetDistances> found =
      search->Run(query, landmarks.get(), checkpoint);
  const std::scoped_lock lock(mutex_);
  idle_.push_back(std::move(search));
  return found;
}

size_t SearchPool::FieldInSearches() {
  const std::scoped_lock lock(mutex_);
  return geodesic::FieldInSearches(landmarks_ == nullptr ? 0
                                                         : landmarks_->count());
}

absl::Status SearchPool::MakeLandmarks(uint32_t count, uint32_t threads,
                                       Checkpoint& checkpoint) {
  {
    const std::scoped_lock lock(mutex_);
    const bool is_enough =
        landmarks_ != nullptr && landmarks_->HasEnough(count);
    if (is_enough || are_being_made_) return absl::OkStatus();
    are_being_made_ = true;
  }
  absl::StatusOr<Landmarks> made =
      geodesic::MakeLandmarks(mesh_, count, {.threads = threads}, checkpoint);
  const std::scoped_lock lock(mutex_);
  are_being_made_ = false;
  if (!made.ok()) return made.status();
  landmarks_ = std::make_shared<const Landmarks>(*std::move(made));
  return absl::OkStatus();
}

}  // namespace geodesic::python
