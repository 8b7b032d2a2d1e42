#include "solver/trimming/trimming.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geodesic {
namespace {

// Distances of two windows at a point of their edge.
struct Contest {
  double at;
  double older, newer;
  double slack;  // beside TieAt

  double difference() const { return newer - older; }
  double tie() const { return TieAt(at, older) + slack; }
  bool newer_wins() const { return difference() < -tie(); }
  bool newer_loses() const { return difference() > tie(); }
};

// Where f0(x) + D = f1(x) for the distances f0, f1 to the two pseudo-sources
// and D = older.sigma - newer.sigma. With t = x - older.x and X = older.x -
// newer.x, squaring twice leaves a t^2 + 2 Q X t + Q^2 - D^2 y0^2 = 0, where
// a = X^2 - D^2 and 2 Q = X^2 + y1^2 - y0^2 - D^2. Its discriminant is
// D^2 (Q^2 + a y0^2). Returns the root in [low, high], or NaN if rounding
// leaves none or two.
double SolveCrossing(const Origin& older, const Origin& newer, double low,
                     double high) {
  const double x_gap = older.x - newer.x;
  const double d = older.sigma - newer.sigma;
  const double q =
      (x_gap * x_gap +
       (newer.depth - older.depth) * (newer.depth + older.depth) - d * d) /
      2;
  const double a = (x_gap - d) * (x_gap + d);
  const double s_squared = q * q + a * older.depth * older.depth;
  const double b = q * x_gap;
  // The root that adds terms of one sign, then the other by their product.
  const double r =
      -(b + std::copysign(d * std::sqrt(std::max(s_squared, 0.0)), b));
  const double x0 = older.x + r / a;
  const double x1 = older.x + (q - d * older.depth) * (q + d * older.depth) / r;
  const bool first = x0 >= low && x0 <= high;
  const bool second = x1 >= low && x1 <= high;
  if (first == second) return std::numeric_limits<double>::quiet_NaN();
  return first ? x0 : x1;
}

double SolveCrossing(const MixedOrigin& older, const MixedOrigin& newer,
                     double low, double high) {
  return older.is_segment || newer.is_segment
             ? std::numeric_limits<double>::quiet_NaN()
             : SolveCrossing(older.AsPoint(), newer.AsPoint(), low, high);
}

// By how much the newer's pseudo-source is nearer to the source. None where one
// is a segment, whose sigma is that of no pseudo-source.
double LeadOfNewer(const Origin& older, const Origin& newer) {
  return older.sigma - newer.sigma;
}
double LeadOfNewer(const MixedOrigin& older, const MixedOrigin& newer) {
  return older.is_segment || newer.is_segment
             ? 0
             : LeadOfNewer(older.AsPoint(), newer.AsPoint());
}

// How fast the distance grows along the edge.
double Slope(const Origin& origin, double at) {
  return (at - origin.x) / origin.DistanceTo(at);
}
double Slope(const MixedOrigin& origin, double at) {
  return origin.is_segment ? origin.x : Slope(origin.AsPoint(), at);
}

// The point of [low, high] where the difference, of different signs at the two
// ends, vanishes: in closed form where that is accurate, else improved by
// Newton's method, else by regula falsi with the Illinois weights and bisection
// where that stalls.
template <typename WindowType>
double FindCrossing(const WindowType& older, const WindowType& newer,
                    double low, double at_low, double high, double at_high) {
  double x = SolveCrossing(older.origin, newer.origin, low, high);
  constexpr int kMostSteps = 100, kNewtonSteps = 4;
  for (int step = 0; step < kMostSteps; ++step) {
    if (!(x > low && x < high)) {
      x = (low * at_high - high * at_low) / (at_high - at_low);
    }
    if (!(x > low && x < high)) x = low + (high - low) / 2;
    if (!(x > low && x < high)) break;  // neighbouring doubles
    const Contest at{x, older.DistanceTo(x), newer.DistanceTo(x), 0};
    const double difference = at.difference();
    if (std::abs(difference) <= kCrossingRoundings * at.tie()) return x;
    if ((difference < 0) == (at_low < 0)) {
      low = x;
      at_low = difference;
      at_high /= 2;
    } else {
      high = x;
      at_high = difference;
      at_low /= 2;
    }
    x = step < kNewtonSteps
            ? x - difference / (Slope(newer.origin, x) - Slope(older.origin, x))
            : std::numeric_limits<double>::quiet_NaN();
  }
  return low + (high - low) / 2;
}

// At the begin (end) of the overlap, which is that of one window at least.
template <typename WindowType>
Contest AtBegin(const WindowType& older, const WindowType& newer,
                double slack) {
  const double a = older.interval.begin, b = newer.interval.begin;
  return {std::max(a, b), a >= b ? older.begin_distance : older.DistanceTo(b),
          b >= a ? newer.begin_distance : newer.DistanceTo(a), slack};
}

template <typename WindowType>
Contest AtEnd(const WindowType& older, const WindowType& newer, double slack) {
  const double a = older.interval.end, b = newer.interval.end;
  return {std::min(a, b), a <= b ? older.end_distance : older.DistanceTo(b),
          b <= a ? newer.end_distance : newer.DistanceTo(a), slack};
}

}  // namespace

double CommonRay(const Origin& a, const Origin& b) {
  return (a.x * b.depth - b.x * a.depth) / (b.depth - a.depth);
}

double CommonRay(const MixedOrigin& a, const MixedOrigin& b) {
  if (!a.is_segment && !b.is_segment) {
    return CommonRay(a.AsPoint(), b.AsPoint());
  }
  if (a.is_segment && b.is_segment) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const MixedOrigin& segment = a.is_segment ? a : b;
  const MixedOrigin& point = a.is_segment ? b : a;
  return point.x + point.depth * segment.x / segment.depth;
}

template <typename OriginType>
Interval WonByNewer(const BasicWindow<OriginType>& older,
                    const BasicWindow<OriginType>& newer, double slack) {
  const double begin = std::max(older.interval.begin, newer.interval.begin);
  const double end = std::min(older.interval.end, newer.interval.end);
  const Contest at_begin = AtBegin(older, newer, slack);
  const Contest at_end = AtEnd(older, newer, slack);
  // Where slack is needed, windows could take ties from each other without end.
  const bool takes_ties =
      slack == 0 &&
      LeadOfNewer(older.origin, newer.origin) > kDominance * at_begin.older;
  const auto newer_gets = [takes_ties](const Contest& at) {
    return takes_ties ? !at.newer_loses() : at.newer_wins();
  };
  const bool gets_begin = newer_gets(at_begin);
  if (!gets_begin && !newer_gets(at_end)) return {begin, begin};
  if (!at_begin.newer_loses() && !at_end.newer_loses()) return {begin, end};
  if (std::signbit(at_begin.difference()) ==
      std::signbit(at_end.difference())) {
    // A tie at one end, and the older nearer at both.
    return {begin, begin};
  }
  const double crossing = FindCrossing(
      older, newer, begin, at_begin.difference(), end, at_end.difference());
  return gets_begin ? Interval{begin, crossing} : Interval{crossing, end};
}

template Interval WonByNewer(const Window& older, const Window& newer,
                             double slack);
template Interval WonByNewer(const MixedWindow& older, const MixedWindow& newer,
                             double slack);

template <typename OriginType>
std::optional<double> SplitBeforeContest(const BasicWindow<OriginType>& older,
                                         const BasicWindow<OriginType>& newer,
                                         double slack) {
  const double at = CommonRay(older.origin, newer.origin);
  const double begin = std::max(older.interval.begin, newer.interval.begin);
  const double end = std::min(older.interval.end, newer.interval.end);
  if (!(at > begin && at < end)) return std::nullopt;
  const Contest at_begin = AtBegin(older, newer, slack);
  const Contest at_end = AtEnd(older, newer, slack);
  const Contest between{at, older.DistanceTo(at), newer.DistanceTo(at), slack};
  const bool newer_passes =
      between.newer_wins() && !at_begin.newer_wins() && !at_end.newer_wins();
  const bool older_passes =
      between.newer_loses() && !at_begin.newer_loses() && !at_end.newer_loses();
  if (!newer_passes && !older_passes) return std::nullopt;
  return at;
}

template std::optional<double> SplitBeforeContest(const Window&, const Window&,
                                                  double);
template std::optional<double> SplitBeforeContest(const MixedWindow&,
                                                  const MixedWindow&, double);

}  // namespace geodesic
