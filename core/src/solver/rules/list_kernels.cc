#include "solver/rules/list_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/windows/vector_loops.h"
#include "solver/windows/window.h"
#include "tolerances.h"

namespace geodesic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

}  // namespace geodesic
