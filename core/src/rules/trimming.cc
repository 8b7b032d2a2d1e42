#include "rules/trimming.h"

#include <cmath>

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

// The point of [low, high] where the difference, of different signs at the two
// ends, vanishes. Regula falsi with the Illinois weights, then bisection where
// that stalls: the difference is smooth with at most one bend, so a handful of
// steps reach a rounding.
double FindCrossing(const Origin& older, const Origin& newer, double low,
                    double at_low, double high, double at_high) {
  constexpr int kMostSteps = 100;
  const double resolution = 1e-16 * (high - low);
  for (int step = 0; step < kMostSteps && high - low > resolution; ++step) {
    double x = (low * at_high - high * at_low) / (at_high - at_low);
    if (!(x > low && x < high)) x = low + (high - low) / 2;
    if (!(x > low && x < high)) break;
    const Difference at = DifferenceAt(older, newer, x);
    if (std::abs(at.value) <= at.tie) return x;
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

Contest Contend(const Origin& older, const Origin& newer,
                const Interval& overlap) {
  const Difference at_begin = DifferenceAt(older, newer, overlap.begin);
  const Difference at_end = DifferenceAt(older, newer, overlap.end);
  const bool wins_begin = at_begin.value < -at_begin.tie;
  const bool wins_end = at_end.value < -at_end.tie;
  const bool loses_begin = at_begin.value > at_begin.tie;
  const bool loses_end = at_end.value > at_end.tie;
  if (wins_begin && loses_end) {
    return {Contest::kNewerBefore,
            FindCrossing(older, newer, overlap.begin, at_begin.value,
                         overlap.end, at_end.value)};
  }
  if (loses_begin && wins_end) {
    return {Contest::kNewerAfter,
            FindCrossing(older, newer, overlap.begin, at_begin.value,
                         overlap.end, at_end.value)};
  }
  return {wins_begin || wins_end ? Contest::kNewerWins : Contest::kOlderWins};
}

}  // namespace geodesic
