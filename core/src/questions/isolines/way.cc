#include "questions/isolines/way.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/surface_location.h"

namespace geodesic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The part of the edge's line that is nearer than `level` from this origin,
// whether or not rays of the window go there.
Interval NearerLine(const MixedOrigin& origin, double level) {
  const double reach = level - origin.sigma;
  if (!origin.is_segment) {
    const double half = std::sqrt(
        std::max((reach - origin.depth) * (reach + origin.depth), 0.0));
    return {origin.x - half, origin.x + half};
  }
  if (origin.x == 0) return {-kInfinity, kInfinity};
  const double end = reach / origin.x;
  return origin.x > 0 ? Interval{-kInfinity, end} : Interval{end, kInfinity};
}

// The part of the edge's line that is nearer than `level` by these ways, or by
// them and then along the edge from an end of the interval. The latter closes
// the gaps that rounding leaves between windows. Its ends are at the level.
std::optional<Interval> NearerPart(const Way& way, double level) {
  const auto& [interval, origin] = way;
  const MixedWindow window = MixedWindow::Over(interval, origin);
  if (!IsNearer(window.Label(), level)) return std::nullopt;
  Interval part = NearerLine(origin, level);
  if (part.begin < interval.begin) {
    part.begin = interval.begin - std::max(level - window.begin_distance, 0.0);
  }
  if (part.end > interval.end) {
    part.end = interval.end + std::max(level - window.end_distance, 0.0);
  }
  return part;
}

bool IsAt(double level, double distance) {
  return std::abs(distance - level) <= level * kAtLevel;
}

}  // namespace

LevelOnEdge::LevelOnEdge(double level, double length, double p, double q)
    : level_(level), length_(length), p_(p), q_(q) {
  if (IsNearer(p, level)) {
    parts_.push_back({-kInfinity, std::min(level - p, length)});
  }
  if (IsNearer(q, level)) {
    parts_.push_back({std::max(length - (level - q), 0.0), kInfinity});
  }
}

void LevelOnEdge::Add(std::span<const Way> ways) {
  for (const Way& way : ways) {
    const std::optional<Interval> part = NearerPart(way, level_);
    if (!part.has_value() || part->end < 0 || part->begin > length_) continue;
    if (parts_.size() == most_parts_) DropCovered();
    parts_.push_back(
        {std::max(part->begin, 0.0), std::min(part->end, length_)});
  }
}

void LevelOnEdge::DropCovered() {
  std::ranges::sort(parts_, [](const Interval& a, const Interval& b) {
    return a.begin != b.begin ? a.begin < b.begin : a.end > b.end;
  });
  double covered_to = -kInfinity;
  std::erase_if(parts_, [&](const Interval& part) {
    if (part.end <= covered_to) return true;
    covered_to = part.end;
    return false;
  });
  most_parts_ = std::max(2 * parts_.size(), kMostParts);
}

std::vector<double> LevelOnEdge::Crossings(bool& have_met) {
  std::ranges::sort(parts_, {}, &Interval::begin);
  std::vector<Interval> pieces;
  const double point = kMeetingPoint * (level_ + length_);
  for (const Interval& part : parts_) {
    if (!pieces.empty() &&
        part.begin <= pieces.back().end + kLeastWidth * length_) {
      const double meeting = pieces.back().end;
      have_met |= part.begin > meeting - point && part.end > meeting + point &&
                  pieces.back().begin < meeting - point;
      pieces.back().end = std::max(pieces.back().end, part.end);
    } else {
      pieces.push_back(part);
    }
  }
  const double snap = kNearMiss * length_;
  std::vector<double> crossings;
  for (Interval& piece : pieces) {
    for (double* end : {&piece.begin, &piece.end}) {
      if (!std::isfinite(*end)) continue;
      if (*end <= snap && IsAt(level_, p_)) *end = 0;
      if (*end >= length_ - snap && IsAt(level_, q_)) *end = length_;
    }
    if (!(piece.width() > 0)) continue;
    if (std::isfinite(piece.begin)) crossings.push_back(piece.begin);
    if (std::isfinite(piece.end)) crossings.push_back(piece.end);
  }
  return crossings;
}

std::optional<Way> GoOnTo(HalfEdge side, const Mesh& mesh, HalfEdge h,
                          const Way& way) {
  const Interval& interval = way.interval;
  const MixedOrigin& origin = way.origin;
  const double crossing = CrossingTo(origin, ApexOf(mesh.frame(h)));
  const auto go_on = [&](const auto& face_side) -> std::optional<Way> {
    if (!face_side.IsReached(interval, crossing)) return std::nullopt;
    const Interval part =
        face_side.InExit(face_side.Hit(origin, interval, crossing));
    if (!(part.width() > 0)) return std::nullopt;
    return Way{part, Unfold(face_side, origin)};
  };
  return side == Prev(h) ? go_on(FaceSide<kLeft>(mesh, h))
                         : go_on(FaceSide<kRight>(mesh, h));
}

std::optional<Way> GoFromSegment(HalfEdge h, const Mesh& mesh,
                                 const CurveSegment& segment, double sigma) {
  const uint32_t opposite = Prev(h) % 3;
  if (segment.begin().weights[opposite] == 0 &&
      segment.end().weights[opposite] == 0) {
    // The segment lies on that side.
    const auto [low, high] = std::minmax({InFrame(mesh, segment.begin(), h).x,
                                          InFrame(mesh, segment.end(), h).x});
    return Way{{low, high},
               {.x = 0, .depth = 1, .sigma = sigma, .is_segment = true}};
  }
  const auto beam = segment.BeamAcross(h);
  if (!beam.has_value()) return std::nullopt;
  Way way = Mirror(Way{beam->interval, beam->origin}, mesh.frame(h).length);
  way.origin.sigma += sigma;
  return way;
}

}  // namespace geodesic
