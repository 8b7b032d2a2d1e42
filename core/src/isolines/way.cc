#include "isolines/way.h"

#include <algorithm>
#include <cmath>

namespace geodesic {

Way Reversed(const Way& way, double length) {
  return {{length - way.interval.end, length - way.interval.begin},
          {.x = length - way.origin.x,
           .depth = way.origin.depth,
           .sigma = way.origin.sigma}};
}

std::optional<Interval> NearerPart(const Way& way, double level) {
  const auto& [interval, origin] = way;
  const Window window = Window::Over(interval, origin);
  const double reach = level - origin.sigma;
  if (!IsNearer(window.Label(), level) || !(reach > origin.depth)) {
    return std::nullopt;
  }
  const double half =
      std::sqrt((reach - origin.depth) * (reach + origin.depth));
  Interval part{origin.x - half, origin.x + half};
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
  const HalfEdgeFrame& frame = mesh.frame(h);
  const double length = mesh.frame(side).length;
  const double crossing = CrossingTo(origin, ApexOf(frame));
  Way on;
  if (side == Prev(h)) {
    if (!(interval.begin < crossing)) return std::nullopt;
    on = {{ProjectLeft(origin, interval.begin, frame, length),
           crossing < interval.end
               ? length
               : ProjectLeft(origin, interval.end, frame, length)},
          UnfoldLeft(origin, frame)};
  } else {
    if (!(interval.end > crossing)) return std::nullopt;
    on = {{crossing > interval.begin
               ? 0
               : length - ProjectRight(origin, interval.begin, frame, length),
           length - ProjectRight(origin, interval.end, frame, length)},
          UnfoldRight(origin, frame, length)};
  }
  if (!(on.interval.width() > 0)) return std::nullopt;
  return on;
}

}  // namespace geodesic
