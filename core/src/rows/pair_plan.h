// Decides which pairs are searched one by one, and which share a field.

#ifndef GEODESIC_ROWS_PAIR_PLAN_H_
#define GEODESIC_ROWS_PAIR_PLAN_H_

#include <cstddef>
#include <span>
#include <vector>

#include "geodesic/rows/pairs.h"

namespace geodesic {

struct PairCosts {
  // Pairs with a common end get a field if they are at least so many.
  size_t least_for_field = 2;
  // Searches that are done one after the other.
  size_t searches_per_row = 32;
};

// The rows of PairQuestion. O(n log n).
// REQUIRES: the points are canonical, so that equal ones compare equal.
std::vector<PairRow> PlanPairs(std::span<const PointPair> pairs,
                               const PairCosts& costs);

}  // namespace geodesic

#endif  // GEODESIC_ROWS_PAIR_PLAN_H_
