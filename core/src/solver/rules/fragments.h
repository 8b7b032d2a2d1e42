// Windows that rounding has cut to pieces.

#ifndef GEODESIC_SOLVER_RULES_FRAGMENTS_H_
#define GEODESIC_SOLVER_RULES_FRAGMENTS_H_

#include "solver/windows/window_columns.h"

namespace geodesic {

// Joins pieces of one window on an edge of this length, sorted and disjoint,
// where a window between them is tied with it (kFragmentTies): that one goes.
//
// The distances of pseudo-sources that lie all but in line differ by the same
// over whole edges. Where that is about kTie, rounding decides who wins, for
// each piece anew, and the pieces of some dozens of such windows become
// thousands in number. The window that is seen on both sides is seen between
// them, too. Lists that are short, or in which hardly any windows alternate,
// are left as they are: they cost less. The distances at the windows' ends are
// neither read nor changed. O(windows).
void JoinFragments(double length, WindowColumns& windows);

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_FRAGMENTS_H_
