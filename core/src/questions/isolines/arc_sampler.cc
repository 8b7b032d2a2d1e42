#include "questions/isolines/arc_sampler.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tolerances.h"

namespace geodesic {
namespace {

// How far places lie from a segment.
class Chord {
 public:
  Chord(const PlanePoint& from, const PlanePoint& to) : from_(from), to_(to) {
    const PlanePoint along = to - from;
    length_ = Norm(along);
    if (length_ > 0) along_ = {along.x / length_, along.y / length_};
  }

  double DistanceTo(const PlanePoint& place) const {
    const PlanePoint away = place - from_;
    const double foot = Dot(along_, away);
    if (foot <= 0) return Norm(away);
    if (foot >= length_) return Norm(place - to_);
    return std::abs(Cross(along_, away));
  }

  // The farthest is an end, or where the arc runs along the chord, or around
  // one of the chord's ends.
  double FarthestOn(const FrontArc& arc) const {
    double farthest = std::max(DistanceTo(arc.From()), DistanceTo(arc.To()));
    if (arc.front.is_straight()) return farthest;
    const PlanePoint& center = arc.front.way().from;
    for (const PlanePoint& out :
         {PlanePoint{-along_.y, along_.x}, PlanePoint{along_.y, -along_.x},
          center - from_, center - to_}) {
      const double at = std::atan2(out.y, out.x);
      if (arc.front.Run(arc.begin, at) < arc.run) {
        farthest = std::max(farthest, DistanceTo(arc.front.At(at)));
      }
    }
    return farthest;
  }

 private:
  PlanePoint from_, to_;
  PlanePoint along_;  // a unit vector; (0, 0) where the ends coincide
  double length_ = 0;
};

double LengthOf(std::span<const FrontArc> arcs) {
  double length = 0;
  for (const FrontArc& arc : arcs) length += arc.front.LengthOf(arc.run);
  return length;
}

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

absl::Status ArcSampler::Within(std::span<const FrontArc> arcs) const {
  if (arcs.empty()) return absl::OkStatus();
  if (absl::Status status = step_(arcs.size()); !status.ok()) return status;
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
  absl::Status status = Within(arcs.first(before));
  if (status.ok()) status = emit_(arcs[before].From());
  if (status.ok()) status = Within(arcs.subspan(before));
  return status;
}

absl::Status ArcSampler::Between(std::span<const FrontArc> arcs) const {
  if (arcs.empty()) return absl::OkStatus();
  const bool leads_back =
      Norm(arcs.front().From() - arcs.back().To()) <= kRoundedPlace;
  return leads_back ? Thirds(arcs) : Within(arcs);
}

absl::Status ArcSampler::Around(std::span<const FrontArc> loop) const {
  if (loop.empty()) return absl::OkStatus();
  absl::Status status = emit_(loop.front().From());
  return status.ok() ? Thirds(loop) : status;
}

absl::Status ArcSampler::Thirds(std::span<const FrontArc> loop) const {
  const double length = LengthOf(loop);
  for (int third = 0; third < 3; ++third) {
    const std::vector<FrontArc> part =
        Part(loop, length * third / 3, length * (third + 1) / 3);
    if (part.empty()) continue;
    absl::Status status;
    if (third > 0) status = emit_(part.front().From());
    if (status.ok()) status = Within(part);
    if (!status.ok()) return status;
  }
  return absl::OkStatus();
}

}  // namespace geodesic
