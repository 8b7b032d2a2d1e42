// Windows that rounding has cut to pieces.

#ifndef GEODESIC_SOLVER_TRIMMING_FRAGMENTS_H_
#define GEODESIC_SOLVER_TRIMMING_FRAGMENTS_H_

#include "solver/windows/window.h"

namespace geodesic {

// The distances of pseudo-sources that lie all but in line differ by the same
// over whole edges. Where that is about kTie, rounding decides who wins, for
// each piece of a window anew, and the pieces of some dozens of such windows
// become thousands in number.

// Whether `before` and `after`, windows of one pseudo-source, are pieces of one
// window on an edge of this length, and `between`, which parts them, is tied
// with it all along (kFragmentTies). What is seen on both sides is seen between
// them, too, so all three may give way to one window. The distances at the
// windows' ends are not read.
template <typename OriginType>
bool AreFragments(const BasicWindow<OriginType>& before,
                  const BasicWindow<OriginType>& between,
                  const BasicWindow<OriginType>& after, double length);

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_TRIMMING_FRAGMENTS_H_
