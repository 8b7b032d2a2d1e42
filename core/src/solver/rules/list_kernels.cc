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

// What the children kernels make a window's label: the least distance, infinite
// if it is useless. As Window::Label, IsLost and Front::EndsAreNearer.
GEODESIC_INLINE double LabelOf(const Interval& part, const Origin& origin,
                               double begin_distance, double end_distance,
                               const ExitEdge& exit) {
  double least =
      part.end < origin.x ? end_distance : origin.sigma + origin.depth;
  least = part.begin > origin.x ? begin_distance : least;
  const double known_at_begin = exit.to_distance + (exit.length - part.begin);
  const double known_at_end = exit.from_distance + part.end;
  const double lost = WidthOfLost(begin_distance - origin.sigma, exit.length);
  least = part.end - part.begin <= lost ? kInfinity : least;
  least = end_distance > known_at_end * (1 + kDominance) ? kInfinity : least;
  return begin_distance > known_at_begin * (1 + kDominance) ? kInfinity : least;
}

}  // namespace

GEODESIC_FOR_EVERY_WIDTH
void CrossingsToApex(const HalfEdgeFrame& frame, const WindowColumns& windows,
                     double* const crossing, double* const miss) {
  const double* const begin = windows.begin;
  const double* const end = windows.end;
  const double* const xs = windows.x;
  const double* const depths = windows.depth;
  const double apex_x = frame.apex_x, apex_y = frame.apex_y;
  const double length = frame.length;
  const size_t n = Padded(windows.size);
  GEODESIC_INDEPENDENT
  for (size_t i = 0; i < n; ++i) {
    const double x = xs[i], depth = depths[i];
    const double height = apex_y + depth;
    const double at = (x * apex_y + apex_x * depth) / height;
    const double slope = std::abs(apex_x - x) / height;
    const double outside = std::max(begin[i] - at, at - end[i]);
    crossing[i] = at;
    miss[i] =
        outside - kNearMiss * (length + std::abs(x) + depth) * (1 + slope);
  }
}

GEODESIC_FOR_EVERY_WIDTH
void DistancesAtEnds(WindowColumns& windows) {
  const double* const begin = windows.begin;
  const double* const end = windows.end;
  const double* const xs = windows.x;
  const double* const depths = windows.depth;
  const double* const sigmas = windows.sigma;
  double* const begin_distance = windows.begin_distance;
  double* const end_distance = windows.end_distance;
  const size_t n = Padded(windows.size);
  GEODESIC_INDEPENDENT
  for (size_t i = 0; i < n; ++i) {
    const double from_begin = begin[i] - xs[i], from_end = end[i] - xs[i];
    const double square = depths[i] * depths[i];
    begin_distance[i] = sigmas[i] + std::sqrt(from_begin * from_begin + square);
    end_distance[i] = sigmas[i] + std::sqrt(from_end * from_end + square);
  }
}

GEODESIC_FOR_EVERY_WIDTH
void ChildrenLeft(const HalfEdgeFrame& frame, const ExitEdge& exit,
                  const WindowColumns& windows, const double* crossing,
                  size_t first, size_t last, WindowColumns& children,
                  double* const label) {
  const double* const begin = windows.begin + first;
  const double* const end = windows.end + first;
  const double* const xs = windows.x + first;
  const double* const depths = windows.depth + first;
  const double* const sigmas = windows.sigma + first;
  const uint32_t* const sources = windows.pseudo_source + first;
  const double* const crossings = crossing + first;
  double* const child_begin = children.begin;
  double* const child_end = children.end;
  double* const child_x = children.x;
  double* const child_depth = children.depth;
  double* const child_sigma = children.sigma;
  double* const begin_distance = children.begin_distance;
  double* const end_distance = children.end_distance;
  const double cosine = frame.left_x, sine = frame.left_y;
  const double length = exit.length;
  children.size = last - first;
  const size_t n = Padded(children.size);
  std::copy_n(sources, n, children.pseudo_source);
  GEODESIC_INDEPENDENT
  for (size_t i = 0; i < n; ++i) {
    const double x = xs[i], depth = depths[i], sigma = sigmas[i];
    const double beside = depth * cosine;
    const double across_begin = beside + (x - begin[i]) * sine;
    const double across_end = beside + (x - end[i]) * sine;
    const double t_begin = depth * begin[i] / across_begin;
    const double t_end = depth * end[i] / across_end;
    double at_begin = t_begin > 0 ? t_begin : 0;
    at_begin = t_begin < length ? at_begin : length;
    at_begin = across_begin > 0 ? at_begin : length;
    double at_end = t_end > 0 ? t_end : 0;
    at_end = t_end < length ? at_end : length;
    at_end = across_end > 0 ? at_end : length;
    at_end = crossings[i] < end[i] ? length : at_end;
    const double new_x = x * cosine - depth * sine;
    const double turned = x * sine + depth * cosine;
    const double new_depth = turned > kLeastHeight ? turned : kLeastHeight;
    const double square = new_depth * new_depth;
    const double to_begin = at_begin - new_x, to_end = at_end - new_x;
    const double d_begin = sigma + std::sqrt(to_begin * to_begin + square);
    const double d_end = sigma + std::sqrt(to_end * to_end + square);
    child_begin[i] = at_begin;
    child_end[i] = at_end;
    child_x[i] = new_x;
    child_depth[i] = new_depth;
    child_sigma[i] = sigma;
    begin_distance[i] = d_begin;
    end_distance[i] = d_end;
    label[i] = LabelOf({at_begin, at_end}, {new_x, new_depth, sigma}, d_begin,
                       d_end, exit);
  }
}

GEODESIC_FOR_EVERY_WIDTH
void ChildrenRight(const HalfEdgeFrame& frame, const ExitEdge& exit,
                   const WindowColumns& windows, const double* crossing,
                   size_t first, size_t last, WindowColumns& children,
                   double* const label) {
  const double* const begin = windows.begin + first;
  const double* const end = windows.end + first;
  const double* const xs = windows.x + first;
  const double* const depths = windows.depth + first;
  const double* const sigmas = windows.sigma + first;
  const uint32_t* const sources = windows.pseudo_source + first;
  const double* const crossings = crossing + first;
  double* const child_begin = children.begin;
  double* const child_end = children.end;
  double* const child_x = children.x;
  double* const child_depth = children.depth;
  double* const child_sigma = children.sigma;
  double* const begin_distance = children.begin_distance;
  double* const end_distance = children.end_distance;
  const double cosine = frame.right_x, sine = frame.right_y;
  const double edge = frame.length;
  const double length = exit.length;
  children.size = last - first;
  const size_t n = Padded(children.size);
  std::copy_n(sources, n, children.pseudo_source);
  GEODESIC_INDEPENDENT
  for (size_t i = 0; i < n; ++i) {
    const double x = xs[i], depth = depths[i], sigma = sigmas[i];
    const double beside = depth * cosine;
    const double across_begin = (begin[i] - x) * sine - beside;
    const double across_end = (end[i] - x) * sine - beside;
    const double t_begin = depth * (edge - begin[i]) / across_begin;
    const double t_end = depth * (edge - end[i]) / across_end;
    double from_b = t_begin > 0 ? t_begin : 0;
    from_b = t_begin < length ? from_b : length;
    from_b = across_begin > 0 ? from_b : length;
    double at_begin = length - from_b;
    at_begin = crossings[i] > begin[i] ? 0 : at_begin;
    double to_b = t_end > 0 ? t_end : 0;
    to_b = t_end < length ? to_b : length;
    to_b = across_end > 0 ? to_b : length;
    const double at_end = length - to_b;
    const double x_from_b = x - edge;
    const double new_x = length - (x_from_b * cosine - depth * sine);
    const double turned = -(x_from_b * sine + depth * cosine);
    const double new_depth = turned > kLeastHeight ? turned : kLeastHeight;
    const double square = new_depth * new_depth;
    const double to_begin = at_begin - new_x, to_end = at_end - new_x;
    const double d_begin = sigma + std::sqrt(to_begin * to_begin + square);
    const double d_end = sigma + std::sqrt(to_end * to_end + square);
    child_begin[i] = at_begin;
    child_end[i] = at_end;
    child_x[i] = new_x;
    child_depth[i] = new_depth;
    child_sigma[i] = sigma;
    begin_distance[i] = d_begin;
    end_distance[i] = d_end;
    label[i] = LabelOf({at_begin, at_end}, {new_x, new_depth, sigma}, d_begin,
                       d_end, exit);
  }
}

GEODESIC_FOR_EVERY_WIDTH
void OverlapsOfNeighbours(double length, const WindowColumns& windows,
                          double* const new_begin, double* const overlap) {
  const double* const begin = windows.begin;
  const double* const end = windows.end;
  const double* const sigmas = windows.sigma;
  const double* const begin_distance = windows.begin_distance;
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const size_t n = Padded(windows.size - 1);
  new_begin[0] = begin[0];
  GEODESIC_INDEPENDENT
  for (size_t i = 0; i < n; ++i) {
    const double low = begin[i + 1], high = end[i];
    const double width = high - low;
    const bool is_rounding =
        width > 0 &&
        width <= WidthOfLost(begin_distance[i + 1] - sigmas[i + 1], length);
    new_begin[i + 1] = is_rounding ? high : low;
    const double left = is_rounding ? 0 : width;
    overlap[i] = low < begin[i] ? kNone : left;
  }
}

void Crossovers::Reserve(size_t count) {
  const size_t room = Padded(count);
  if (at.size() >= room) return;
  pair.resize(2 * room);
  for (auto* column : {&end, &end_distance, &x, &depth, &sigma, &next_begin,
                       &next_end, &next_begin_distance, &next_x, &next_depth,
                       &next_sigma, &at, &distance, &next_distance}) {
    column->resize(2 * room);
  }
}

GEODESIC_FOR_EVERY_WIDTH
void FindCrossovers(Crossovers& crossovers) {
  const double* const lows = crossovers.next_begin.data();
  const double* const highs = crossovers.end.data();
  const double* const next_ends = crossovers.next_end.data();
  const double* const xs = crossovers.x.data();
  const double* const depths = crossovers.depth.data();
  const double* const sigmas = crossovers.sigma.data();
  const double* const next_xs = crossovers.next_x.data();
  const double* const next_depths = crossovers.next_depth.data();
  const double* const next_sigmas = crossovers.next_sigma.data();
  const double* const next_begin_distance =
      crossovers.next_begin_distance.data();
  const double* const end_distance = crossovers.end_distance.data();
  double* const meeting = crossovers.at.data();
  double* const distance = crossovers.distance.data();
  double* const next_distance = crossovers.next_distance.data();
  const size_t n = Padded(crossovers.size);
  GEODESIC_INDEPENDENT
  for (size_t i = 0; i < n; ++i) {
    const double x0 = xs[i], y0 = depths[i], sigma0 = sigmas[i];
    const double x1 = next_xs[i], y1 = next_depths[i], sigma1 = next_sigmas[i];
    const double low = lows[i], high = highs[i];
    const double square0 = y0 * y0, square1 = y1 * y1;
    const double low0 = low - x0, high1 = high - x1;
    const double at_low = sigma0 + std::sqrt(low0 * low0 + square0);
    const double at_high = sigma1 + std::sqrt(high1 * high1 + square1);
    // As SolveCrossing, in trimming.cc.
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
    const double end0 = x - x0, end1 = x - x1;
    const double older = sigma0 + std::sqrt(end0 * end0 + square0);
    const double newer = sigma1 + std::sqrt(end1 * end1 + square1);
    const double off = std::abs(newer - older);
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    double at = off <= kCrossingRoundings * kTie * older ? x : kNone;
    at = x > low ? at : kNone;
    at = x < high ? at : kNone;
    at = high <= next_ends[i] ? at : kNone;
    at = next_begin_distance[i] - at_low > kTie * at_low ? at : kNone;
    at = at_high - end_distance[i] < -kTie * end_distance[i] ? at : kNone;
    meeting[i] = at;
    distance[i] = older;
    next_distance[i] = newer;
  }
}

}  // namespace geodesic
