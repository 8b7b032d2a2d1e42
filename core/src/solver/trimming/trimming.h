// Which of two windows on a half-edge is nearer where. For neighbours in lists
// trimming_kernels.h decides the usual case in the same way.

#ifndef GEODESIC_SOLVER_TRIMMING_TRIMMING_H_
#define GEODESIC_SOLVER_TRIMMING_TRIMMING_H_

#include <algorithm>
#include <optional>

#include "solver/windows/mixed_origin.h"
#include "solver/windows/window.h"
#include "tolerances.h"

namespace geodesic {

// Two windows are tied at a point of their edge if their distances there differ
// by no more than this.
inline double TieAt(double at, double distance) {
  return std::max(kTie * distance, kRoundedPosition * at);
}

// Where rays of both pseudo-sources coincide: there the difference of their
// distances is greatest or least. NaN or infinite if nowhere.
double CommonRay(const Origin& a, const Origin& b);
double CommonRay(const MixedOrigin& a, const MixedOrigin& b);

// The part of two windows' overlap where the newer is nearer; of width 0 if the
// older keeps all of it. Ties (kTie, and `slack`) go to the window of the
// lesser sigma, or else, and wherever there is slack or a segment, to the
// older.
//
// Where pseudo-sources lie all but in one line, their windows tie over whole
// intervals, and the paths by way of the second are really as long as the first
// one's or longer. Were such intervals shared, there would be a gap between
// the rays of the two, which diverge from where the shares meet.
//
// Decided by the distances at both ends of the overlap. That is exact: the
// difference of the two distances has its only extremum where the line through
// both pseudo-sources meets the edge, and no window reaches across that point,
// because its ray runs through the nearer pseudo-source, a vertex, and windows
// end at vertices. Equal signs at the ends thus mean one sign throughout, and
// different signs exactly one crossing.
// REQUIRES: the windows overlap, and SplitBeforeContest has nothing to split.
template <typename OriginType>
Interval WonByNewer(const BasicWindow<OriginType>& older,
                    const BasicWindow<OriginType>& newer, double slack = 0);

// That ray may run through a pseudo-source that is no vertex, though, and end
// no window, or the two windows may have come along it by different faces of
// one edge (Front::MayChangeOverTwice). The point where it meets the edge, if
// the window that is nearer there is nearer at neither end of the overlap: on
// either side of that point WonByNewer holds again. REQUIRES: the windows
// overlap.
template <typename OriginType>
std::optional<double> SplitBeforeContest(const BasicWindow<OriginType>& older,
                                         const BasicWindow<OriginType>& newer,
                                         double slack = 0);

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_TRIMMING_TRIMMING_H_
