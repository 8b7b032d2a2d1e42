#include "questions/first_path/first_path.h"

#include <cmath>
#include <limits>

#include "questions/first_path/place.h"

namespace geodesic {

absl::Status FirstPath::Find(std::span<const Anchor> anchors,
                             const SurfacePoint& target, const Goal& goal,
                             absl::FunctionRef<absl::Status()> poll) {
  length_ = std::numeric_limits<double>::infinity();
  starts_.clear();
  for (const Anchor& anchor : anchors) {
    starts_.push_back({Place::Of(mesh_, anchor.begin),
                       std::ldexp(anchor.offset, -mesh_.scale_exponent())});
  }
  const Place end = Place::Of(mesh_, target);
  absl::Status status = routes_.Find(starts_, end, goal, poll, route_);
  if (!status.ok() || route_.steps.empty()) return status;
  const RouteStart& start = starts_[route_.start];
  status = path_.Draw(start.place, route_, end, poll);
  length_ = start.offset + path_.length();
  return status;
}

}  // namespace geodesic
