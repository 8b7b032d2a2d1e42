#include "questions/isolines/level_tracer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "tolerances.h"

namespace geodesic {
namespace {

// What is no longer, in multiples of what is shallow, is rounding.
constexpr double kLeastGap = 64;
// Fronts pass a place that is no farther from them, in the same multiples.
constexpr double kPassing = 4;

}  // namespace

double FrontArc::Height() const {
  if (front.is_straight()) return 0;
  if (run > Front::kFullCircle / 2) {
    return std::numeric_limits<double>::infinity();
  }
  const double sine = std::sin(run / 4);
  return 2 * front.radius() * sine * sine;
}

LevelTracer::LevelTracer(const FaceWays& ways, double level, const Step& step)
    : ways_(ways),
      level_(level),
      step_(step),
      shallow_(kAtLevel * level + kRoundedPlace) {
  for (const FaceWay& way : ways.ways()) {
    if (IsNearer(way.label, level)) fronts_.emplace_back(way, level);
  }
}

LevelTracer::Stretch LevelTracer::NextStretch(const Front& front, double from) {
  Stretch stretch{front.is_straight() ? Front::kNoEnd : Front::kFullCircle};
  for (const HalfPlane& side : ways_.sides()) {
    const double run = front.RunWithin(side, from, shallow_, ways_.size());
    if (run < stretch.run) stretch = {run, true};
  }
  for (const HalfPlane& bound : front.way().Bounds()) {
    const double run = front.RunWithin(bound, from, 0, ways_.size());
    if (run < stretch.run) stretch = {run, false};
  }
  if (!std::isfinite(stretch.run)) return {};
  const FrontArc arc{front, from, stretch.run};
  const PlanePoint begin = arc.From(), end = arc.To();
  const double height = arc.Height();
  for (const Front& other : fronts_) {
    if (!(stretch.run > 0)) break;
    if (&other.way() == &front.way() || other.IsWithin(front) ||
        std::ranges::any_of(other.way().Bounds(), [&](const HalfPlane& bound) {
          return std::max(bound.Depth(begin), bound.Depth(end)) < -height;
        })) {
      continue;
    }
    parts_.clear();
    front.AddCovered(other.way(), from, stretch.run, shallow_, parts_);
    for (const Interval& part : parts_) {
      if (part.begin < stretch.run) stretch = {part.begin, false};
    }
  }
  return stretch;
}

absl::StatusOr<std::optional<FrontArc>> LevelTracer::GoOn(
    const PlanePoint& place, bool& leaves_face) {
  double least = std::numeric_limits<double>::infinity();
  for (const Front& front : fronts_) {
    if (front.way().LeadsTo(place, shallow_)) {
      least = std::min(least, front.way().DistanceTo(place));
    }
  }
  std::optional<FrontArc> best;
  double longest = shallow_;
  leaves_face = false;
  for (const Front& front : fronts_) {
    if (!front.way().LeadsTo(place, shallow_)) continue;
    if (front.way().DistanceTo(place) > least + kPassing * shallow_) continue;
    if (absl::Status status = step_(fronts_.size()); !status.ok()) {
      return status;
    }
    const double begin = front.ParameterOf(place);
    const Stretch stretch = NextStretch(front, begin);
    const double length = front.LengthOf(stretch.run);
    if (length > longest) {
      longest = length;
      best = FrontArc{front, begin, stretch.run};
      leaves_face = stretch.leaves_face;
    }
  }
  if (!best.has_value()) {
    leaves_face =
        std::ranges::any_of(ways_.sides(), [&](const HalfPlane& side) {
          return side.Depth(place) <= kPassing * shallow_;
        });
  }
  return best;
}

absl::StatusOr<LevelTracer::Trace> LevelTracer::TraceFrom(
    const PlanePoint& place) {
  Trace trace;
  PlanePoint at = place;
  // The boundary of n convex parts has O(n) arcs.
  const size_t most = 16 * (fronts_.size() + 4);
  while (trace.arcs.size() < most) {
    bool leaves_face = false;
    absl::StatusOr<std::optional<FrontArc>> next = GoOn(at, leaves_face);
    if (!next.ok()) return next.status();
    if (next->has_value()) {
      trace.arcs.push_back(**next);
      traced_.push_back(**next);
      at = (*next)->To();
    }
    if (leaves_face) {
      trace.exit = at;
      return trace;
    }
    if (!next->has_value()) return trace;
  }
  return trace;
}

bool LevelTracer::MayHaveLoops() const {
  // Two convex parts enclose nothing.
  size_t crossing = 0;
  for (const Front& front : fronts_) {
    if (front.way().farthest > level_) {
      ++crossing;
    } else if (front.way().bound_count == 0) {
      return false;  // it covers the whole face
    }
  }
  return ways_.has_sources() ? crossing > 0 : crossing >= 3;
}

std::vector<double> LevelTracer::BarePlaces(const Front& front) {
  double begin = 0, run = Front::kFullCircle;
  if (front.is_straight()) {
    const auto [low, high] = std::ranges::minmax(
        ways_.corners(), {},
        [&](const PlanePoint& corner) { return front.ParameterOf(corner); });
    begin = front.ParameterOf(low);
    run = front.ParameterOf(high) - begin;
  }
  parts_.clear();
  for (const HalfPlane& side : ways_.sides()) {
    front.AddOutside(side, begin, run, parts_);
  }
  for (const HalfPlane& bound : front.way().Bounds()) {
    front.AddOutside(bound, begin, run, parts_);
  }
  for (const Front& other : fronts_) {
    if (&other.way() == &front.way()) continue;
    front.AddCovered(other.way(), begin, run, shallow_, parts_);
  }
  parts_.push_back({run, run});
  std::ranges::sort(parts_, {}, &Interval::begin);
  std::vector<double> places;
  double covered_to = 0;
  for (const Interval& part : parts_) {
    if (front.LengthOf(part.begin - covered_to) > kLeastGap * shallow_) {
      places.push_back(begin + (covered_to + part.begin) / 2);
    }
    covered_to = std::max(covered_to, part.end);
  }
  return places;
}

bool LevelTracer::Passes(const FrontArc& arc, const PlanePoint& place) const {
  const auto& [front, begin, run] = arc;
  if (std::abs(front.way().DistanceTo(place) - level_) > kPassing * shallow_ ||
      !front.way().LeadsTo(place, shallow_)) {
    return false;
  }
  const double to_place = front.Run(begin, front.ParameterOf(place));
  return to_place >= 0 && to_place <= run;
}

absl::StatusOr<bool> LevelTracer::Close(const FrontArc& first_stretch,
                                        std::vector<FrontArc>& arcs) {
  const PlanePoint start = first_stretch.From();
  FrontArc arc = first_stretch;
  const size_t most = 16 * (fronts_.size() + 4);
  while (arcs.size() < most) {
    arcs.push_back(arc);
    traced_.push_back(arc);
    if (!arc.front.is_straight() && arc.run >= Front::kFullCircle) return true;
    if (arcs.size() > 1 && Passes(arc, start)) {
      arcs.back().run = arc.front.Run(arc.begin, arc.front.ParameterOf(start));
      return true;
    }
    bool leaves_face = false;
    absl::StatusOr<std::optional<FrontArc>> next = GoOn(arc.To(), leaves_face);
    if (!next.ok()) return next.status();
    if (!next->has_value()) return false;
    arc = **next;
    if (leaves_face && !Passes(arc, start)) return false;
  }
  return false;
}

bool LevelTracer::IsTraced(const PlanePoint& place) const {
  return std::ranges::any_of(
      traced_, [&](const FrontArc& arc) { return Passes(arc, place); });
}

absl::StatusOr<bool> LevelTracer::HasUntraced() {
  for (const Front& front : fronts_) {
    if (absl::Status status = step_(fronts_.size()); !status.ok()) {
      return status;
    }
    for (const double at : BarePlaces(front)) {
      if (absl::Status status = step_(traced_.size()); !status.ok()) {
        return status;
      }
      if (!IsTraced(front.At(at))) return true;
    }
  }
  return false;
}

absl::StatusOr<std::vector<std::vector<FrontArc>>> LevelTracer::Loops() {
  std::vector<std::vector<FrontArc>> loops;
  if (!MayHaveLoops()) return loops;
  for (const Front& front : fronts_) {
    if (absl::Status status = step_(fronts_.size()); !status.ok()) {
      return status;
    }
    for (const double at : BarePlaces(front)) {
      if (absl::Status status = step_(traced_.size()); !status.ok()) {
        return status;
      }
      const PlanePoint place = front.At(at);
      if (IsTraced(place)) continue;
      const Stretch stretch = NextStretch(front, at);
      if (stretch.leaves_face) {
        has_lost_some_ = true;
        continue;
      }
      std::vector<FrontArc> arcs;
      absl::StatusOr<bool> is_closed = Close({front, at, stretch.run}, arcs);
      if (!is_closed.ok()) return is_closed.status();
      if (*is_closed) {
        loops.push_back(std::move(arcs));
      } else {
        has_lost_some_ = true;
      }
    }
  }
  return loops;
}

}  // namespace geodesic
