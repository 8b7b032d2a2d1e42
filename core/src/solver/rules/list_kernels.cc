#include "solver/rules/list_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/windows/window.h"
#include "tolerances.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GEODESIC_FOR_EVERY_WIDTH \
  __attribute__((target_clones("avx2", "default")))
#else
#define GEODESIC_FOR_EVERY_WIDTH
#endif

// Into each of the versions.
#if defined(__GNUC__)
#define GEODESIC_INLINE inline __attribute__((always_inline))
#else
#define GEODESIC_INLINE inline
#endif

// Before a loop whose columns do not overlap.
#if defined(__GNUC__) && !defined(__clang__)
#define GEODESIC_INDEPENDENT _Pragma("GCC ivdep")
#else
#define GEODESIC_INDEPENDENT
#endif

namespace geodesic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Whole vectors: what lies behind a list's end is computed along with it, and
// nobody looks at that.
size_t Padded(size_t count) {
  constexpr size_t kStep = WindowColumns::kPadding;
  return (count + kStep - 1) / kStep * kStep;
}

// As Window::Label, but infinite if the window is useless: as IsLost and
// Front::EndsAreNearer say.
GEODESIC_INLINE double LabelOf(const Window& window, const ExitEdge& exit) {
  const auto& [part, origin, begin_distance, end_distance] = window;
  const double lost = WidthOfLost(begin_distance - origin.sigma, exit.length);
  const double from_begin = exit.from_distance + part.end;
  const double from_end = exit.to_distance + (exit.length - part.begin);
  double least = LeastDistance(origin, part, begin_distance, end_distance);
  least = part.width() <= lost ? kInfinity : least;
  least = Exceeds(end_distance, from_begin) ? kInfinity : least;
  return Exceeds(begin_distance, from_end) ? kInfinity : least;
}

// By value what the loop reads: it would have to be read again after each
// write.
template <Side kSide>
GEODESIC_INLINE void ChildrenOf(const FaceSide<kSide> side, const ExitEdge exit,
                                const WindowColumns& windows,
                                const double* const crossing, size_t first,
                                size_t last, WindowColumns& children,
                                double* const label) {
  children.size = last - first;
  const size_t n = Padded(children.size);
  std::copy_n(windows.pseudo_source + first, n, children.pseudo_source);
  GEODESIC_INDEPENDENT
  for (size_t i = 0; i < n; ++i) {
    const Origin origin = windows.OriginAt(first + i);
    const Interval hit =
        side.Hit(origin, windows.IntervalAt(first + i), crossing[first + i]);
    const Window child = Window::Over(side.InExit(hit), Unfold(side, origin));
    children.Set(i, child);
    label[i] = LabelOf(child, exit);
  }
}

// The goal by value, too.
template <typename Goal>
GEODESIC_INLINE void KeysToward(const Goal goal, double length,
                                const WindowColumns& windows,
                                double* const label) {
  const size_t n = Padded(windows.size);
  GEODESIC_INDEPENDENT
  for (size_t i = 0; i < n; ++i) {
    label[i] = KeyOf(windows.At(i), label[i], length, goal);
  }
}

}  // namespace

GEODESIC_FOR_EVERY_WIDTH
void CrossingsToApex(const HalfEdgeFrame& frame, const WindowColumns& windows,
                     double* const crossing, double* const miss) {
  const HalfEdgeFrame face = frame;
  const size_t n = Padded(windows.size);
  GEODESIC_INDEPENDENT
  for (size_t i = 0; i < n; ++i) {
    const Origin origin = windows.OriginAt(i);
    const auto [begin, end] = windows.IntervalAt(i);
    const double at = CrossingTo(origin, ApexOf(face));
    crossing[i] = at;
    miss[i] =
        std::max(begin - at, at - end) - NearMiss(origin, face, ApexOf(face));
  }
}

GEODESIC_FOR_EVERY_WIDTH
void ChildrenAcross(const FaceSide<kLeft>& side, const ExitEdge& exit,
                    const WindowColumns& windows, const double* crossing,
                    size_t first, size_t last, WindowColumns& children,
                    double* label) {
  ChildrenOf(side, exit, windows, crossing, first, last, children, label);
}

GEODESIC_FOR_EVERY_WIDTH
void ChildrenAcross(const FaceSide<kRight>& side, const ExitEdge& exit,
                    const WindowColumns& windows, const double* crossing,
                    size_t first, size_t last, WindowColumns& children,
                    double* label) {
  ChildrenOf(side, exit, windows, crossing, first, last, children, label);
}

GEODESIC_FOR_EVERY_WIDTH
void KeysOf(const WindowColumns& windows, double length, const EdgeGoal& goal,
            double* const label) {
  KeysToward(goal, length, windows, label);
}

GEODESIC_FOR_EVERY_WIDTH
void KeysOf(const WindowColumns& windows, double length, const NearEdge& goal,
            double* const label) {
  KeysToward(goal, length, windows, label);
}

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
    // As SolveCrossing, in trimming.cc.
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
