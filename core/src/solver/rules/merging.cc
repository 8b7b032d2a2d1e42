#include "solver/rules/merging.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tolerances.h"

namespace geodesic {
namespace {
constexpr double kFar = std::numeric_limits<double>::infinity();
}

bool FindMerged(const Window& first, const Window& second, double most,
                MergedWindow& merged) {
  const Origin& s1 = first.origin;
  const Origin& s2 = second.origin;
  const double begin = first.interval.begin, end = second.interval.end;
  const double middle = first.interval.end;
  // They touch, but for what is too narrow to hold.
  const double gap = std::abs(second.interval.begin - middle);
  const double agreed = kAgreed * std::min(first.Label(), second.Label());
  if (!(gap <= agreed)) return false;
  const double at_begin = first.begin_distance, at_end = second.end_distance;
  const double first_at = first.end_distance;
  const double second_at = second.begin_distance;
  const double jump = std::abs(first_at - second_at);
  if (!(jump <= agreed)) return false;

  // The origin s' of what is sought has |s' end| - |s' begin| = rise: it lies
  // on a branch of a hyperbola. The nearer to the edge it lies there, the more
  // do its rays lean outward; those at begin and end each say how far it may
  // be.
  const double width = end - begin, rise = at_end - at_begin;
  const double to_begin = s1.DistanceTo(begin), to_end = s2.DistanceTo(end);
  const double narrow = kLeastBeam * std::max(first_at, width);
  if (!(s1.depth * width > narrow * to_begin &&
        s2.depth * width > narrow * to_end)) {
    return false;
  }
  const double begin_slope = (begin - s1.x) / to_begin;
  const double end_slope = (end - s2.x) / to_end;
  const double square = (width - rise) * (width + rise) / 2;
  if (!(square > 0)) return false;
  const double over_begin = rise - width * begin_slope;
  const double over_end = width * end_slope - rise;
  // Measured from begin.
  const double on_begin_ray = over_begin > 0 ? square / over_begin : kFar;
  const double on_end_ray = over_end > 0 ? square / over_end - rise : kFar;
  const double farthest = kFarthestMerged * first_at;
  Origin origin;
  double from_begin = farthest;
  if (farthest <= on_begin_ray && farthest <= on_end_ray) {
    const double along = (square - farthest * rise) / width;
    origin = {.x = begin + along,
              .depth = std::sqrt(
                  std::max((farthest - along) * (farthest + along), 0.0))};
  } else if (on_begin_ray <= on_end_ray) {
    from_begin = on_begin_ray;
    origin = {.x = begin - on_begin_ray * begin_slope,
              .depth = on_begin_ray * (s1.depth / to_begin)};
  } else {
    from_begin = on_end_ray;
    const double from_end = on_end_ray + rise;
    origin = {.x = end - from_end * end_slope,
              .depth = from_end * (s2.depth / to_end)};
  }
  origin.sigma = at_begin - from_begin;
  const double from_end = from_begin + rise;
  if (!(origin.depth * width > narrow * std::max(from_begin, from_end))) {
    return false;
  }
  const double rounding =
      kMergedRounding * (first_at + from_begin + from_end) + gap;
  // Where the rays to both ends lean far apart, rounding along the edge counts
  // many times: then it is not the distances at the ends that come out.
  const double off = std::max(std::abs(origin.PathTo(begin) - at_begin),
                              std::abs(origin.PathTo(end) - at_end));
  if (!(off <= rounding)) return false;
  origin.sigma -= off;

  // Where it is nearest beside either: at the middle, or else on the line
  // through both origins.
  const double to_middle = origin.DistanceTo(middle);
  const double below =
      std::max(first_at, second_at) - (origin.sigma + to_middle);
  if (below < -agreed || below > most) return false;
  const double slope = (middle - origin.x) / to_middle;
  const auto below_between = [&](const Origin& s) {
    return std::max(below,
                    (s.sigma - origin.sigma) +
                        std::hypot(s.x - origin.x, s.depth - origin.depth));
  };
  const double first_slope = (middle - s1.x) / s1.DistanceTo(middle);
  const double second_slope = (middle - s2.x) / s2.DistanceTo(middle);
  const double below_first =
      (first_slope >= slope ? below : below_between(s1)) + rounding;
  const double below_second =
      (second_slope <= slope ? below : below_between(s2)) + rounding;
  if (!(std::max(below_first, below_second) <= most)) return false;
  // The same where they are nearest, beside a source that is near: there
  // rounding along the edge is much of the distance.
  const auto agrees = [&](const Origin& s, double from, double to,
                          double nearer) {
    const double at = std::clamp(s.x, from, to);
    const double left = s.PathTo(at) - origin.PathTo(at);
    return left >= -rounding && left <= nearer + rounding;
  };
  if (!agrees(s1, begin, middle, below_first) ||
      !agrees(s2, middle, end, below_second)) {
    return false;
  }
  merged = {{{begin, end}, origin, at_begin, at_end},
            std::max(below_first, 0.0),
            std::max(below_second, 0.0)};
  return true;
}

}  // namespace geodesic
