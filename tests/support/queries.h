// Queries that are known to be valid, and distances that answer them.

#ifndef GEODESIC_TESTS_SUPPORT_QUERIES_H_
#define GEODESIC_TESTS_SUPPORT_QUERIES_H_

#include <algorithm>
#include <cmath>
#include <span>
#include <variant>
#include <vector>

#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/valid_query.h"

namespace geodesic::test {

// REQUIRES: the query is valid; the program ends where it is not.
inline ValidQuery Valid(const Mesh& mesh, const Query& query) {
  return ValidQuery::Make(query, mesh).value();
}

// REQUIRES: the source is a point.
inline const SurfacePoint& PointOf(const Source& source) {
  return std::get<SurfacePoint>(source.place);
}

// Distances of the vertices, then of the targets.
inline std::vector<double> AllDistances(const DistanceField& field) {
  std::vector<double> all = field.distances;
  all.insert(all.end(), field.target_distances.begin(),
             field.target_distances.end());
  return all;
}

// The largest that is finite.
inline double FarthestOf(std::span<const double> distances) {
  double farthest = 0;
  for (const double d : distances) {
    if (std::isfinite(d)) farthest = std::max(farthest, d);
  }
  return farthest;
}

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_QUERIES_H_
