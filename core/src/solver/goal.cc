#include "solver/goal.h"

#include <algorithm>
#include <utility>

#include "tolerances.h"

namespace geodesic {

void Goal::Aim(const SurfacePoint& target, const Landmarks* landmarks) {
  Clear();
  target_ = InSpace(mesh_, target);
  landmarks_ =
      landmarks != nullptr && landmarks->count() > 0 ? landmarks : nullptr;
  if (landmarks_ != nullptr) {
    from_landmarks_ = landmarks_->PlaceOf(target, mesh_);
  }
  refined_ = nullptr;
  limit_ = std::numeric_limits<double>::infinity();
}

void Goal::Refine(std::function<double(uint32_t)> bound) {
  Clear();
  refined_ = std::move(bound);
}

void Goal::Clear() {
  for (const uint32_t v : known_) bounds_[v] = kUnknown;
  known_.clear();
}

double Goal::Compute(uint32_t v) const {
  double bound = StraightDistance(mesh_, SpacePoint{.vertex = v}, target_);
  if (landmarks_ != nullptr) {
    bound = std::max(bound, landmarks_->LowerBound(v, from_landmarks_));
  }
  if (refined_) bound = std::max(bound, refined_(v));
  known_.push_back(v);
  return bounds_[v] = std::max(bound - kGoalRounding, 0.0);
}

}  // namespace geodesic
