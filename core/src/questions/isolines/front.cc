#include "questions/isolines/front.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace geodesic {
namespace {

// In [0, kFullCircle).
double Normalized(double angle) {
  const double turned = std::fmod(angle, Front::kFullCircle);
  return turned < 0 ? turned + Front::kFullCircle : turned;
}

// Places along a front, of which there are few.
class Cuts {
 public:
  Cuts(double run) : run_(run) { Add(0); }

  void Add(double at) {
    if (at >= 0 && at <= run_) cuts_[count_++] = at;
  }
  // Calls visit(part) for the parts between them, in order.
  template <typename Visit>
  void ForEachPart(Visit visit) {
    Add(run_);
    std::sort(cuts_.begin(), cuts_.begin() + count_);
    for (size_t i = 1; i < count_; ++i) {
      const Interval part{cuts_[i - 1], cuts_[i]};
      if (part.width() > 0) visit(part);
    }
  }

 private:
  const double run_;
  // The ends, a circle's two crossings and those of three bounds.
  std::array<double, 10> cuts_;
  size_t count_ = 0;
};

}  // namespace

PlanePoint Front::At(double parameter) const {
  const PlanePoint& from = way_->from;
  if (is_straight()) {
    return {from.x * reach_ - from.y * parameter,
            from.y * reach_ + from.x * parameter};
  }
  return {from.x + reach_ * std::cos(parameter),
          from.y + reach_ * std::sin(parameter)};
}

double Front::ParameterOf(const PlanePoint& place) const {
  if (is_straight()) return Cross(way_->from, place);
  const PlanePoint ray = place - way_->from;
  return std::atan2(ray.y, ray.x);
}

double Front::Run(double from, double to) const {
  return is_straight() ? to - from : Normalized(to - from);
}

double Front::RunWithin(const HalfPlane& half_plane, double from,
                        double shallow, double size) const {
  const PlanePoint& normal = half_plane.normal;
  if (is_straight()) {
    const double depth = half_plane.Depth(At(from));
    const double rise = Cross(way_->from, normal);
    if (rise >= 0 || depth + rise * size >= -shallow) return kNoEnd;
    return std::max(depth / -rise, 0.0);
  }
  const double depth = half_plane.Depth(way_->from);
  if (depth >= reach_ - shallow) return kNoEnd;
  if (depth <= -reach_) return 0;
  const double half = std::acos(-depth / reach_);
  const double past_middle =
      std::remainder(from - std::atan2(normal.y, normal.x), kFullCircle);
  // Before it begins, the front is about to enter.
  return std::max(half - past_middle, 0.0);
}

template <typename Visit>
void Front::ForEachCrossing(const HalfPlane& half_plane, double from,
                            Visit visit) const {
  const PlanePoint& normal = half_plane.normal;
  if (is_straight()) {
    const double rise = Cross(way_->from, normal);
    if (rise != 0) visit(-half_plane.Depth(At(from)) / rise);
    return;
  }
  const double depth = half_plane.Depth(way_->from);
  if (!(std::abs(depth) < reach_)) return;
  const double half = std::acos(-depth / reach_);
  const double middle = std::atan2(normal.y, normal.x) - from;
  visit(Normalized(middle - half));
  visit(Normalized(middle + half));
}

template <typename Visit>
void Front::ForEachCrossing(const PlanePoint& center, double radius,
                            double from, Visit visit) const {
  if (is_straight()) {
    const double beside = Dot(way_->from, center) - reach_;
    if (!(std::abs(beside) < radius)) return;
    const double half = std::sqrt((radius - beside) * (radius + beside));
    const double middle = Cross(way_->from, center) - from;
    visit(middle - half);
    visit(middle + half);
    return;
  }
  const PlanePoint between = center - way_->from;
  const double distance = Norm(between);
  const double cosine =
      (distance * distance + (reach_ - radius) * (reach_ + radius)) /
      (2 * distance * reach_);
  if (!(std::abs(cosine) < 1)) return;
  const double half = std::acos(cosine);
  const double middle = std::atan2(between.y, between.x) - from;
  visit(Normalized(middle - half));
  visit(Normalized(middle + half));
}

void Front::AddOutside(const HalfPlane& half_plane, double from, double run,
                       std::vector<Interval>& parts) const {
  Cuts cuts(run);
  ForEachCrossing(half_plane, from, [&](double at) { cuts.Add(at); });
  cuts.ForEachPart([&](const Interval& part) {
    const double middle = (part.begin + part.end) / 2;
    if (half_plane.Depth(At(from + middle)) < 0) parts.push_back(part);
  });
}

void Front::AddCovered(const FaceWay& other, double from, double run,
                       double shallow, std::vector<Interval>& parts) const {
  Cuts cuts(run);
  const auto add = [&](double at) { cuts.Add(at); };
  if (other.is_segment) {
    ForEachCrossing(
        HalfPlane{{-other.from.x, -other.from.y}, other.sigma - level_}, from,
        add);
  } else {
    ForEachCrossing(other.from, level_ - other.sigma, from, add);
  }
  for (const HalfPlane& bound : other.Bounds()) {
    ForEachCrossing(bound, from, add);
  }
  cuts.ForEachPart([&](const Interval& part) {
    const PlanePoint middle = At(from + (part.begin + part.end) / 2);
    if (other.DistanceTo(middle) < level_ - shallow &&
        other.LeadsTo(middle, 0)) {
      parts.push_back(part);
    }
  });
}

}  // namespace geodesic
