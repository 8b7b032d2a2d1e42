#include "solver/goal.h"

#include "tolerances.h"

namespace geodesic {

void Goal::Aim(std::span<const SurfacePoint> targets,
               const Landmarks* landmarks) {
  Clear();
  landmarks_ =
      landmarks != nullptr && landmarks->count() > 0 ? landmarks : nullptr;
  targets_.clear();
  for (const SurfacePoint& target : targets) {
    targets_.push_back({.place = InSpace(mesh_, target)});
    if (landmarks_ == nullptr) continue;
    targets_.back().from_landmarks = landmarks_->PlaceOf(target, mesh_);
  }
  limit_ = std::numeric_limits<double>::infinity();
}

void Goal::Clear() {
  for (const uint32_t v : known_) bounds_[v] = kUnknown;
  known_.clear();
}

double Goal::Compute(uint32_t v) const {
  const SpacePoint place{.vertex = v};
  double least = std::numeric_limits<double>::infinity();
  for (const Target& target : targets_) {
    double bound = StraightDistance(mesh_, place, target.place);
    if (landmarks_ != nullptr) {
      bound = std::max(bound, landmarks_->LowerBound(v, target.from_landmarks));
    }
    least = std::min(least, bound - kGoalRounding);
  }
  known_.push_back(v);
  return bounds_[v] = std::max(least, 0.0);
}

}  // namespace geodesic
