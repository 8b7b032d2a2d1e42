// Merging two neighbouring windows of a half-edge into one, which is never
// farther than they are and covers what they cover (docs/algorithm.md, 22).
//
// [b, m] and [m, e] touch and agree at m. The merged origin gives the old
// distances at b and e, so it lies on a hyperbola with these foci; the nearer
// to the edge, the more its rays lean outward. Of the places whose rays at b
// and e coincide with the old ones or lean outward, it takes the farthest.
// Along the old ray that it keeps, the difference to that window is monotone;
// to the other it has one extremum, and no room for a change of sign unless the
// rays part at m. Such windows stay apart; so do those where directions would
// be rounding (kLeastBeam). By how much it is nearer at most is found at m, or
// where the line through both origins meets the edge.

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
