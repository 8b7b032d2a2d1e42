// What is computed for every window of a list when it crosses a face: loops
// without branches over columns, compiled for several widths of vectors. They
// use no operation whose rounding depends on the width, so neither do the
// results.

#ifndef GEODESIC_SOLVER_RULES_LIST_KERNELS_H_
#define GEODESIC_SOLVER_RULES_LIST_KERNELS_H_

#include <cstddef>

#include "geodesic/mesh.h"
#include "solver/goal.h"
#include "solver/windows/window.h"
#include "solver/windows/window_columns.h"

namespace geodesic {

// Where the ray into the apex of the face crosses each window's edge, and by
// how much more than NearMiss it misses the window: not above 0 if the window
// relaxes the apex.
void CrossingsToApex(const HalfEdgeFrame& frame, const WindowColumns& windows,
                     double* crossing, double* miss);

// An edge that windows are handed on to, and what its ends know.
struct ExitEdge {
  double length;
  double from_distance, to_distance;
};

// The children of windows [first, last) across a side of the face, in the frame
// of its exit, in the same order. label: the least distance of each; infinite
// for one that is useless: too narrow, or farther than paths through the ends
// of the edge (the first two conditions of the Xin-Wang filter).
void ChildrenAcross(const FaceSide<kLeft>& side, const ExitEdge& exit,
                    const WindowColumns& windows, const double* crossing,
                    size_t first, size_t last, WindowColumns& children,
                    double* label);
void ChildrenAcross(const FaceSide<kRight>& side, const ExitEdge& exit,
                    const WindowColumns& windows, const double* crossing,
                    size_t first, size_t last, WindowColumns& children,
                    double* label);

// Makes keys of the labels of windows on an edge of this length (goal.h).
void KeysOf(const WindowColumns& windows, double length, const EdgeGoal& goal,
            double* label);
void KeysOf(const WindowColumns& windows, double length, const NearEdge& goal,
            double* label);

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_LIST_KERNELS_H_
