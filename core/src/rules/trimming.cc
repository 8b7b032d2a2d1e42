#include "rules/trimming.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geodesic {
namespace {

// newer's distance minus older's at (x, 0), without subtracting nearly equal
// distances, and what two roundings of such a distance come to.
struct Difference {
  double value;
  double tie;
};

Difference DifferenceAt(const Origin& older, const Origin& newer, double x) {
  const double f0 = older.DistanceTo(x), f1 = newer.DistanceTo(x);
  const double by_place =
      ((newer.x - older.x) * (newer.x + older.x - 2 * x) +
       (newer.depth - older.depth) * (newer.depth + older.depth)) /
      (f0 + f1);
  return {newer.sigma - older.sigma + by_place, kTie * (older.sigma + f0)};
}

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

// The point of [low, high] where the difference, of different signs at the two
// ends, vanishes: in closed form where that is accurate, else by regula falsi
// with the Illinois weights and bisection where that stalls.
double FindCrossing(const Origin& older, const Origin& newer, double low,
                    double at_low, double high, double at_high) {
  double x = SolveCrossing(older, newer, low, high);
  constexpr int kMostSteps = 100;
  for (int step = 0; step < kMostSteps; ++step) {
    if (!(x > low && x < high)) {
      x = (low * at_high - high * at_low) / (at_high - at_low);
    }
    if (!(x > low && x < high)) x = low + (high - low) / 2;
    if (!(x > low && x < high)) break;  // neighbouring doubles
    const Difference at = DifferenceAt(older, newer, x);
    if (std::abs(at.value) <= kCrossingRoundings * at.tie) return x;
    if ((at.value < 0) == (at_low < 0)) {
      low = x;
      at_low = at.value;
      at_high /= 2;
    } else {
      high = x;
      at_high = at.value;
      at_low /= 2;
    }
  }
  return low + (high - low) / 2;
}

}  // namespace

Interval WonByNewer(const Origin& older, const Origin& newer,
                    const Interval& overlap) {
  const auto& [begin, end] = overlap;
  const Difference at_begin = DifferenceAt(older, newer, begin);
  const Difference at_end = DifferenceAt(older, newer, end);
  const bool wins_begin = at_begin.value < -at_begin.tie;
  const bool wins_end = at_end.value < -at_end.tie;
  if (!wins_begin && !wins_end) return {begin, begin};
  const bool loses_begin = at_begin.value > at_begin.tie;
  const bool loses_end = at_end.value > at_end.tie;
  if (!loses_begin && !loses_end) return overlap;
  const double crossing =
      FindCrossing(older, newer, begin, at_begin.value, end, at_end.value);
  return wins_begin ? Interval{begin, crossing} : Interval{crossing, end};
}

}  // namespace geodesic
