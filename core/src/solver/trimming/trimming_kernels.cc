#include "solver/trimming/trimming_kernels.h"

#include <cmath>
#include <cstddef>
#include <limits>

#include "solver/windows/vector_loops.h"
#include "solver/windows/window.h"
#include "tolerances.h"

namespace geodesic {

GEODESIC_FOR_EVERY_WIDTH
void OverlapsOfNeighbours(double length, const WindowColumns& windows,
                          double* const new_begin, double* const overlap) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const size_t n = Padded(windows.size - 1);
  new_begin[0] = windows.begin[0];
  GEODESIC_INDEPENDENT
  for (size_t i = 0; i < n; ++i) {
    const double low = windows.begin[i + 1], high = windows.end[i];
    const double width = high - low;
    const double distance =
        windows.begin_distance[i + 1] - windows.sigma[i + 1];
    const bool is_rounding =
        width > 0 && width <= WidthOfLost(distance, length);
    new_begin[i + 1] = is_rounding ? high : low;
    const double left = is_rounding ? 0 : width;
    overlap[i] = low < windows.begin[i] ? kNone : left;
  }
}

GEODESIC_FOR_EVERY_WIDTH
void FindCrossovers(WindowColumns& older, WindowColumns& newer,
                    double* const meeting) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const size_t n = Padded(older.size);
  GEODESIC_INDEPENDENT
  for (size_t i = 0; i < n; ++i) {
    const auto [x0, y0, sigma0] = older.OriginAt(i);
    const auto [x1, y1, sigma1] = newer.OriginAt(i);
    const double low = newer.begin[i], high = older.end[i];
    const double newer_at_low = newer.begin_distance[i];
    const double older_at_high = older.end_distance[i];
    const double at_low = older.OriginAt(i).PathTo(low);
    const double at_high = newer.OriginAt(i).PathTo(high);
    // As SolveCrossing in trimming.cc.
    const double square0 = y0 * y0, square1 = y1 * y1;
    const double gap = x0 - x1, d = sigma0 - sigma1;
    const double q = (gap * gap + (y1 - y0) * (y1 + y0) - d * d) / 2;
    const double a = (gap - d) * (gap + d);
    const double s_squared = q * q + a * square0;
    const double s = std::abs(d) * std::sqrt(s_squared > 0 ? s_squared : 0);
    const double b = q * gap;
    const double r = -(b + std::copysign(s, b));
    const double root0 = x0 + r / a;
    const double root1 = x0 + (q - d * y0) * (q + d * y0) / r;
    double x = root0 < low ? root1 : root0;
    x = root0 > high ? root1 : x;
    // One step of Newton's method.
    const double from0 = x - x0, from1 = x - x1;
    const double to0 = std::sqrt(from0 * from0 + square0);
    const double to1 = std::sqrt(from1 * from1 + square1);
    const double slope = (from1 * to0 - from0 * to1) / (to0 * to1);
    x -= ((sigma1 - sigma0) + (to1 - to0)) / slope;
    const double older_at = older.OriginAt(i).PathTo(x);
    const double newer_at = newer.OriginAt(i).PathTo(x);
    const double off = std::abs(newer_at - older_at);
    double at = off <= kCrossingRoundings * kTie * older_at ? x : kNone;
    at = x > low ? at : kNone;
    at = x < high ? at : kNone;
    at = high <= newer.end[i] ? at : kNone;
    at = newer_at_low - at_low > kTie * at_low ? at : kNone;
    at = at_high - older_at_high < -kTie * older_at_high ? at : kNone;
    meeting[i] = at;
    older.end_distance[i] = older_at;
    newer.begin_distance[i] = newer_at;
  }
}

}  // namespace geodesic
