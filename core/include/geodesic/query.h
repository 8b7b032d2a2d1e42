// A question about distances on a mesh.

#ifndef GEODESIC_QUERY_H_
#define GEODESIC_QUERY_H_

#include <algorithm>
#include <vector>

#include "geodesic/surface_point.h"
#include "geodesic_types/algorithms.h"
#include "geodesic_types/places.h"
#include "geodesic_types/questions.h"

namespace geodesic {

// The field is d(x) = min over sources of offset + geodesic distance to x.
struct Query {
  // At least one. A source's number is its index here.
  std::vector<Source> sources;
  // Points beside the vertices whose distances are wanted.
  std::vector<SurfacePoint> targets = {};
  Algorithm algorithm = kDefaultAlgorithm;
  // Whether to keep how each shortest path arrives (DistanceField::arrivals),
  // which paths, nearest sources, gradients and log maps need. Takes 24 bytes a
  // vertex.
  bool trace = false;
  // The largest relative error that distances may have, 0 or in
  // [kLeastTolerance, kMostTolerance]. DEFAULT: 0, exact. Otherwise fwp-list
  // merges windows, which takes less time on large meshes, and the field
  // certifies the error of every distance (DistanceField::certified_errors). A
  // trace, whatever else runs, and what is asked for within less than 1e-5 is
  // exact: ValidQuery then has 0 here.
  double tolerance = 0;

  friend auto operator<=>(const Query&, const Query&) = default;
};

// Whether any source is a curve.
inline bool HasCurves(const Query& query) {
  return std::ranges::any_of(query.sources, IsCurve);
}

}  // namespace geodesic

#endif  // GEODESIC_QUERY_H_
