// Merging two neighbouring windows of a half-edge into one, which is never
// farther than they are and covers what they cover (docs/algorithm.md, 22).

#ifndef GEODESIC_SOLVER_RULES_MERGING_H_
#define GEODESIC_SOLVER_RULES_MERGING_H_

#include "solver/windows/window.h"

namespace geodesic {

// A window in the place of two, and by how much at the most it is nearer than
// either of them, somewhere on its interval.
struct MergedWindow {
  Window window;
  double below_first = 0;
  double below_second = 0;
};

// Guarantees of what is found, up to rounding, which is in below_first and
// below_second:
//   1. at the begin of `first` and the end of `second` it has their distances;
//   2. its rays through these points coincide with theirs or lie outward, so it
//      covers all beyond the edge that they cover;
//   3. nowhere between is it farther than they are.
// Returns false, and changes nothing, if there is none: the two do not touch
// or differ where they do, or their rays part there; or if it would be nearer
// by more than `most` somewhere. REQUIRES: `first` ends before `second` does.
bool FindMerged(const Window& first, const Window& second, double most,
                MergedWindow& merged);

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_MERGING_H_
