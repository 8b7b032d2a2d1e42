// What is computed for every window of a list when it crosses a face: loops
// without branches over columns, compiled for several widths of vectors. They
// use no operation whose rounding depends on the width, so neither do the
// results.

#ifndef GEODESIC_SOLVER_RULES_LIST_KERNELS_H_
#define GEODESIC_SOLVER_RULES_LIST_KERNELS_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geodesic/mesh.h"
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

// Of a list: where its windows begin, if they give up what they share with the
// one before by rounding alone: that is no wider than a window may be lost with
// (IsLost). overlap: by how much window i then still reaches into window
// i + 1; NaN if window i + 1 begins before window i.
void OverlapsOfNeighbours(double length, const WindowColumns& windows,
                          double* begin, double* overlap);

// Pairs of neighbours in a list that overlap, and where they change over, if
// the next one ends last and each is nearer on its own side: the case of
// WonByNewer that wavefronts meeting in a face make. Columns of `size` pairs.
struct Crossovers {
  size_t size = 0;
  std::vector<uint32_t> pair;  // windows i and i + 1
  // Of the first window, and of the next.
  std::vector<double> end, end_distance, x, depth, sigma;
  std::vector<double> next_begin, next_end, next_begin_distance, next_x,
      next_depth, next_sigma;
  // Results.
  std::vector<double> at;  // NaN: another case
  std::vector<double> distance, next_distance;

  // Makes room for `count` pairs.
  void Reserve(size_t count);
};
void FindCrossovers(Crossovers& crossovers);

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_LIST_KERNELS_H_
