#include "questions/isolines/way.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/surface_location.h"

namespace geodesic {
namespace {

// The part of the edge's line that is nearer than `level` from this origin,
// whether or not rays of the window go there.
Interval NearerLine(const MixedOrigin& origin, double level) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
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

}  // namespace

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

std::optional<Way> GoOnTo(HalfEdge side, const Mesh& mesh, HalfEdge h,
                          const Way& way) {
  const auto& [interval, origin] = way;
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
