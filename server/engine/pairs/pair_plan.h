// Decides which pairs are searched one by one, and which share a field.

#ifndef GEODESIC_SERVER_ENGINE_PAIRS_PAIR_PLAN_H_
#define GEODESIC_SERVER_ENGINE_PAIRS_PAIR_PLAN_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geodesic/surface_point.h"

namespace geodesic::server {

// Two points whose distance is asked for. It is the same in both directions.
struct PointPair {
  SurfacePoint source;
  SurfacePoint target;
};

struct PairCosts {
  // Pairs with a common end get a field if they are at least so many.
  size_t least_for_field = 2;
  // Searches that are done one after the other.
  size_t searches_per_row = 32;
};

// Pairs that are answered together.
struct PairRow {
  // An end that all pairs of the row have: a field from there answers them. If
  // there is none, each pair is searched.
  std::optional<SurfacePoint> shared;
  // Their numbers, ascending.
  std::vector<uint32_t> pairs;
};

// Every pair is in one row. Rows are ordered by their first pair. Equal
// questions have equal plans. O(n log n).
// REQUIRES: the points are canonical, so that equal ones compare equal.
std::vector<PairRow> PlanPairs(std::span<const PointPair> pairs,
                               const PairCosts& costs);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_PAIRS_PAIR_PLAN_H_
