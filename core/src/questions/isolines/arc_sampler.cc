#include "questions/isolines/arc_sampler.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace geodesic {
namespace {

// How far places lie beside a line, or (where its ends coincide) from a point.
class Chord {
 public:
  Chord(const PlanePoint& from, const PlanePoint& to) : from_(from) {
    const PlanePoint along = to - from;
    const double length = Norm(along);
    if (length > 0) normal_ = {-along.y / length, along.x / length};
  }

  double DistanceTo(const PlanePoint& place) const {
    const PlanePoint away = place - from_;
    return normal_.x == 0 && normal_.y == 0 ? Norm(away)
                                            : std::abs(Dot(normal_, away));
  }

  double FarthestOn(const FrontArc& arc) const {
    double farthest = std::max(DistanceTo(arc.From()), DistanceTo(arc.To()));
    if (arc.front.is_straight()) return farthest;
    const PlanePoint& center = arc.front.way().from;
    const PlanePoint out =
        normal_.x == 0 && normal_.y == 0 ? center - from_ : normal_;
    for (const double sign : {1.0, -1.0}) {
      const double at = std::atan2(sign * out.y, sign * out.x);
      if (arc.front.Run(arc.begin, at) < arc.run) {
        farthest = std::max(farthest, DistanceTo(arc.front.At(at)));
      }
    }
    return farthest;
  }

 private:
  PlanePoint from_;
  PlanePoint normal_;
};

// The part between two lengths along the arcs.
std::vector<FrontArc> Part(std::span<const FrontArc> arcs, double from,
                           double to) {
  std::vector<FrontArc> part;
  double passed = 0;
  for (const FrontArc& arc : arcs) {
    const double length = arc.front.LengthOf(arc.run);
    const double begin = std::clamp((from - passed) / length, 0.0, 1.0);
    const double end = std::clamp((to - passed) / length, 0.0, 1.0);
    if (begin < end) {
      part.push_back(
          {arc.front, arc.begin + arc.run * begin, arc.run * (end - begin)});
    }
    passed += length;
  }
  return part;
}

}  // namespace

absl::Status ArcSampler::Along(const FrontArc& arc) const {
  if (arc.front.is_straight()) return absl::OkStatus();
  // A chord of the angle a is r (1 - cos(a / 2)) = 2 r sin^2(a / 4) off.
  const double most = 4 * std::asin(std::sqrt(std::min(
                              chord_error_ / (2 * arc.front.radius()), 1.0)));
  const double count = std::ceil(arc.run / most);
  for (double i = 1; i < count; ++i) {
    absl::Status status =
        emit_(arc.front.At(arc.begin + arc.run * (i / count)));
    if (!status.ok()) return status;
  }
  return absl::OkStatus();
}

absl::Status ArcSampler::Between(std::span<const FrontArc> arcs) const {
  if (arcs.empty()) return absl::OkStatus();
  const Chord chord(arcs.front().From(), arcs.back().To());
  double farthest = 0;
  for (const FrontArc& arc : arcs) {
    farthest = std::max(farthest, chord.FarthestOn(arc));
  }
  if (farthest <= chord_error_) return absl::OkStatus();
  if (arcs.size() == 1) return Along(arcs.front());
  const auto joint = std::ranges::max_element(
      arcs.subspan(1), {},
      [&](const FrontArc& arc) { return chord.DistanceTo(arc.From()); });
  const auto before = static_cast<size_t>(joint - arcs.begin());
  absl::Status status = Between(arcs.first(before));
  if (status.ok()) status = emit_(arcs[before].From());
  if (status.ok()) status = Between(arcs.subspan(before));
  return status;
}

absl::Status ArcSampler::Around(std::span<const FrontArc> loop) const {
  double length = 0;
  for (const FrontArc& arc : loop) length += arc.front.LengthOf(arc.run);
  for (int third = 0; third < 3; ++third) {
    const std::vector<FrontArc> part =
        Part(loop, length * third / 3, length * (third + 1) / 3);
    if (part.empty()) continue;
    absl::Status status = emit_(part.front().From());
    if (status.ok()) status = Between(part);
    if (!status.ok()) return status;
  }
  return absl::OkStatus();
}

}  // namespace geodesic
