// A question about distances on a mesh.

#ifndef GEODESIC_QUERY_H_
#define GEODESIC_QUERY_H_

#include <algorithm>
#include <variant>
#include <vector>

#include "geodesic/algorithm.h"
#include "geodesic/surface_point.h"

namespace geodesic {

// A polyline on the surface. Points that follow each other lie in a common
// face, where the segment between them runs straight. If several faces hold
// both points, there is a segment in each of them.
struct Curve {
  std::vector<SurfacePoint> points;  // at least one

  friend auto operator<=>(const Curve&, const Curve&) = default;
};

// Distances are measured from a source, which is a point or every point of a
// curve.
struct Source {
  std::variant<SurfacePoint, Curve> place;
  // In the unit of the mesh's file; finite, >= 0, and at most about 1e6 times
  // the mesh's extent, since rounding would swamp the mesh beside a larger one.
  double offset = 0;

  friend auto operator<=>(const Source&, const Source&) = default;
};

// Whether the source is a curve, not a point.
inline bool IsCurve(const Source& source) {
  return std::holds_alternative<Curve>(source.place);
}

// The range of tolerances other than 0.
inline constexpr double kLeastTolerance = 1e-9;
inline constexpr double kMostTolerance = 0.1;

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
