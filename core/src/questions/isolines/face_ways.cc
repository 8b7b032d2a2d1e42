#include "questions/isolines/face_ways.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace geodesic {
namespace {

constexpr Way kNowhere{{0, -1}, {}};

// The place on the edge that a way reaches first.
double NearestOf(const Way& way) {
  const auto& [interval, origin] = way;
  if (!origin.is_segment) {
    return std::clamp(origin.x, interval.begin, interval.end);
  }
  return origin.x > 0 ? interval.begin : interval.end;
}

}  // namespace

FaceWays::FaceWays(const Mesh& mesh, uint32_t face)
    : mesh_(mesh), first_(mesh.FirstSide(face)) {
  const HalfEdgeFrame& frame = mesh.frame(first_);
  corners_ = {{{0, 0}, {frame.length, 0}, {frame.apex_x, frame.apex_y}}};
  directions_ = {
      {{1, 0}, {frame.right_x, frame.right_y}, {-frame.left_x, -frame.left_y}}};
}

PlanePoint FaceWays::InFrameOfSide(uint32_t side,
                                   const PlanePoint& point) const {
  const PlanePoint from_corner = point - corners_[side];
  return {Dot(directions_[side], from_corner),
          Cross(directions_[side], from_corner)};
}

PlanePoint FaceWays::FromFrameOfSide(uint32_t side,
                                     const PlanePoint& point) const {
  const auto& [ux, uy] = directions_[side];
  return {corners_[side].x + point.x * ux - point.y * uy,
          corners_[side].y + point.x * uy + point.y * ux};
}

void FaceWays::AddThrough(HalfEdge h, const Way& way) {
  const uint32_t entry = h % 3;
  const MixedOrigin& origin = way.origin;
  FaceWay added{.is_segment = origin.is_segment,
                .sigma = origin.sigma,
                .entry = entry,
                .on_side = {kNowhere, kNowhere, kNowhere}};
  if (origin.is_segment) {
    const auto& [ux, uy] = directions_[entry];
    added.from = {origin.x * ux - origin.depth * uy,
                  origin.x * uy + origin.depth * ux};
    added.sigma -= Dot(added.from, corners_[entry]);
  } else {
    added.from = FromFrameOfSide(entry, {origin.x, -origin.depth});
  }
  added.on_side[entry] = way;
  for (const HalfEdge side : {Next(h), Prev(h)}) {
    const std::optional<Way> on = GoOnTo(side, mesh_, h, way);
    if (!on.has_value()) continue;
    added.on_side[side % 3] = Mirror(*on, mesh_.frame(side).length);
  }
  ways_.push_back(added);
}

void FaceWays::AddWithin(const PlanePoint& from, double sigma) {
  FaceWay added{.from = from, .sigma = sigma};
  for (uint32_t side = 0; side < 3; ++side) {
    const PlanePoint at = InFrameOfSide(side, from);
    added.on_side[side] = {{0, mesh_.frame(first_ + side).length},
                           {at.x, std::max(at.y, kLeastHeight), sigma}};
  }
  ways_.push_back(added);
}

void FaceWays::AddWithin(const CurveSegment& segment, double sigma) {
  FaceWay added{.is_segment = true, .sigma = sigma};
  for (uint32_t side = 0; side < 3; ++side) {
    added.on_side[side] =
        GoFromSegment(first_ + side, mesh_, segment, sigma).value_or(kNowhere);
  }
  ways_.push_back(added);
}

void FaceWays::JoinRegions(double level, FaceRegions& regions) const {
  std::vector<std::pair<const FaceWay*, size_t>> in_regions;  // way, arc
  for (const FaceWay& way : ways_) {
    std::optional<size_t> first_arc;
    for (uint32_t side = 0; side < 3; ++side) {
      const auto& [interval, origin] = way.on_side[side];
      if (!(interval.width() > 0)) continue;
      if (!IsNearer(way.on_side[side].Label(), level)) continue;
      const double nearest = NearestOf(way.on_side[side]);
      const std::optional<size_t> arc =
          regions.ArcAt(side + nearest / mesh_.frame(first_ + side).length);
      if (!arc.has_value()) continue;
      if (!first_arc.has_value()) {
        first_arc = arc;
        in_regions.emplace_back(&way, *arc);
      }
      regions.Join(*first_arc, *arc);
    }
  }
  for (size_t i = 0; i < in_regions.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      const auto& [a, arc_of_a] = in_regions[i];
      const auto& [b, arc_of_b] = in_regions[j];
      if (!regions.AreJoined(arc_of_a, arc_of_b) && Meet(*a, *b, level)) {
        regions.Join(arc_of_a, arc_of_b);
      }
    }
  }
}

std::optional<PlanePoint> FaceWays::MeetingPoint(const FaceWay& a,
                                                 const FaceWay& b) const {
  if (a.is_segment && b.is_segment) return std::nullopt;
  if (a.is_segment) return MeetingPoint(b, a);
  // What is left between a's pseudo-source and b's, or b's rays there.
  PlanePoint towards_b;
  double left;
  if (b.is_segment) {
    if (b.entry == kWithin) return std::nullopt;
    towards_b = {-b.from.x, -b.from.y};
    left = Dot(b.from, a.from);
  } else {
    towards_b = b.from - a.from;
    left = std::hypot(towards_b.x, towards_b.y);
    if (!(left > 0)) return std::nullopt;
    towards_b = {towards_b.x / left, towards_b.y / left};
  }
  const double from_a = (left + b.sigma - a.sigma) / 2;
  if (!(from_a >= 0 && (b.is_segment || from_a <= left))) return std::nullopt;
  return PlanePoint{a.from.x + towards_b.x * from_a,
                    a.from.y + towards_b.y * from_a};
}

bool FaceWays::Meet(const FaceWay& a, const FaceWay& b, double level) const {
  const std::optional<PlanePoint> middle = MeetingPoint(a, b);
  if (!middle.has_value()) return false;
  const FaceWay& point = a.is_segment ? b : a;
  const PlanePoint way = *middle - point.from;
  const double distance = point.sigma + std::hypot(way.x, way.y);
  return IsNearer(distance, level) && Sees(a, *middle) && Sees(b, *middle);
}

bool FaceWays::Sees(const FaceWay& way, const PlanePoint& point) const {
  for (uint32_t side = 0; side < 3; ++side) {
    const PlanePoint at = InFrameOfSide(side, point);
    if (at.y < 0) return false;
    if (side != way.entry) continue;
    const auto& [interval, origin] = way.on_side[side];
    const double through = CrossingTo(origin, at);
    if (through < interval.begin || through > interval.end) return false;
  }
  return true;
}

}  // namespace geodesic
