// Which of two windows on a half-edge is nearer where.

#ifndef GEODESIC_RULES_TRIMMING_H_
#define GEODESIC_RULES_TRIMMING_H_

#include "windows/window.h"

namespace geodesic {

// How the overlap [begin, end] of an older and a newer window is shared.
struct Contest {
  enum Outcome {
    kOlderWins,    // all of it
    kNewerWins,    // all of it
    kNewerBefore,  // the newer wins [begin, crossing], the older the rest
    kNewerAfter,   // the newer wins [crossing, end], the older the rest
  };
  Outcome outcome;
  double crossing = 0;
};

// Decides by the distances at both ends of the overlap. That is exact: the
// difference of the two distances has its only extremum where the line through
// both pseudo-sources meets the edge, and no window reaches across that point,
// because its ray runs through the nearer pseudo-source, a vertex, and windows
// end at vertices. Equal signs at the ends thus mean one sign throughout, and
// different signs exactly one crossing. Ties (kTie) go to the older window.
// REQUIRES: overlap.begin < overlap.end.
Contest Contend(const Origin& older, const Origin& newer,
                const Interval& overlap);

}  // namespace geodesic

#endif  // GEODESIC_RULES_TRIMMING_H_
