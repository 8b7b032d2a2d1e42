#include "isolines/face_ways.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace geodesic {
namespace {

constexpr Way kNowhere{{0, -1}, {}};

}  // namespace

FaceWays::FaceWays(const Mesh& mesh, uint32_t face)
    : mesh_(mesh), first_(3 * face) {
  const HalfEdgeFrame& frame = mesh.frame(first_);
  corners_ = {{{0, 0}, {frame.length, 0}, {frame.apex_x, frame.apex_y}}};
  directions_ = {
      {{1, 0}, {frame.right_x, frame.right_y}, {-frame.left_x, -frame.left_y}}};
}

PlanePoint FaceWays::InFrameOfSide(uint32_t side,
                                   const PlanePoint& point) const {
  const auto& [ux, uy] = directions_[side];
  const double dx = point.x - corners_[side].x;
  const double dy = point.y - corners_[side].y;
  return {dx * ux + dy * uy, dy * ux - dx * uy};
}

PlanePoint FaceWays::FromFrameOfSide(uint32_t side,
                                     const PlanePoint& point) const {
  const auto& [ux, uy] = directions_[side];
  return {corners_[side].x + point.x * ux - point.y * uy,
          corners_[side].y + point.x * uy + point.y * ux};
}

void FaceWays::AddThrough(HalfEdge h, const Way& way) {
  FaceWay added{
      .from = FromFrameOfSide(h % 3, {way.origin.x, -way.origin.depth}),
      .sigma = way.origin.sigma,
      .entry = h % 3,
      .on_side = {kNowhere, kNowhere, kNowhere}};
  added.on_side[h % 3] = way;
  for (const HalfEdge side : {Next(h), Prev(h)}) {
    const std::optional<Way> on = GoOnTo(side, mesh_, h, way);
    if (!on.has_value()) continue;
    added.on_side[side % 3] = Reversed(*on, mesh_.frame(side).length);
  }
  ways_.push_back(added);
}

void FaceWays::AddWithin(const PlanePoint& from, double sigma) {
  FaceWay added{.from = from, .sigma = sigma, .entry = kWithin, .on_side = {}};
  for (uint32_t side = 0; side < 3; ++side) {
    const PlanePoint at = InFrameOfSide(side, from);
    added.on_side[side] = {{0, mesh_.frame(first_ + side).length},
                           {at.x, std::max(at.y, kLeastHeight), sigma}};
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
      const Window window = Window::Over(interval, origin);
      if (!IsNearer(window.Label(), level)) continue;
      const double nearest = std::clamp(origin.x, interval.begin, interval.end);
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

bool FaceWays::Meet(const FaceWay& a, const FaceWay& b, double level) const {
  const double dx = b.from.x - a.from.x;
  const double dy = b.from.y - a.from.y;
  const double apart = std::hypot(dx, dy);
  // Where both are equally far.
  const double from_a = (apart + b.sigma - a.sigma) / 2;
  if (!(from_a >= 0 && from_a <= apart) || apart == 0) return false;
  if (!IsNearer(a.sigma + from_a, level)) return false;
  const PlanePoint middle{a.from.x + dx * from_a / apart,
                          a.from.y + dy * from_a / apart};
  return Sees(a, middle) && Sees(b, middle);
}

bool FaceWays::Sees(const FaceWay& way, const PlanePoint& point) const {
  for (uint32_t side = 0; side < 3; ++side) {
    const PlanePoint at = InFrameOfSide(side, point);
    if (at.y < 0) return false;
    if (side != way.entry) continue;
    const auto& [interval, origin] = way.on_side[side];
    const double through =
        (origin.x * at.y + at.x * origin.depth) / (at.y + origin.depth);
    if (through < interval.begin || through > interval.end) return false;
  }
  return true;
}

}  // namespace geodesic
