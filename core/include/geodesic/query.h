// What is asked of a mesh.

#ifndef GEODESIC_QUERY_H_
#define GEODESIC_QUERY_H_

#include <cstdint>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/algorithm.h"
#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"

namespace geodesic {

// A point from which distances are measured.
struct Source {
  SurfacePoint point;
  // In the unit of the mesh's file; finite, >= 0, and at most about 1e6 times
  // the mesh's extent, beside which the mesh would be lost in rounding.
  double offset = 0;

  friend auto operator<=>(const Source&, const Source&) = default;
};

// A polyline on the surface from every point of which distances are measured.
// Points that follow each other lie in a common face, where the segment between
// them runs straight; in each, if several faces hold both.
struct CurveSource {
  std::vector<SurfacePoint> points;  // at least one
  double offset = 0;                 // as a Source's

  friend auto operator<=>(const CurveSource&, const CurveSource&) = default;
};

// The field is d(x) = min over sources and curves of offset + geodesic
// distance to x.
struct Query {
  std::vector<Source> sources;
  std::vector<CurveSource> curves;
  // Points beside the vertices whose distances are wanted.
  std::vector<SurfacePoint> targets;
  Algorithm algorithm = kDefaultAlgorithm;
  // Whether to keep how each shortest path arrives (DistanceField::arrivals):
  // what paths, labels, gradients and log maps are made from. 24 bytes a
  // vertex.
  bool trace = false;

  friend bool operator==(const Query&, const Query&) = default;
};

// Sources are numbered through: sources[i] is i, curves[j] is
// sources.size() + j.
inline uint32_t SourceCount(const Query& query) {
  return static_cast<uint32_t>(query.sources.size() + query.curves.size());
}

// Checks a query against the mesh.
// Errors: INVALID_ARGUMENT naming the offender, e.g. "sources[3].vertex 991 is
// out of range: the mesh has 502 vertices, numbered from 0".
absl::Status Validate(const Query& query, const Mesh& mesh);

// The algorithm that runs for this query. Chen and Han's rule (one angle, one
// split) needs windows that end at pseudo-sources and rays that meet when they
// are followed back; where there are several sources and not all are vertices,
// or curves, or edges of three faces or more, the MMP rule takes its place. So
// it does on meshes with faces without area, where rays coincide
// (docs/algorithm.md, 6, 13 and 16). REQUIRES: Validate(query, mesh).ok().
Algorithm AlgorithmFor(const Query& query, const Mesh& mesh);

// The same question in one fixed form: the algorithm that runs, points
// canonical, sources sorted by point, of equal points only the least offset
// kept, -0 made 0. Curves and targets keep their order. Two queries with the
// same field-defining content have equal canonical forms. REQUIRES:
// Validate(query, mesh).ok().
Query Canonicalize(Query query, const Mesh& mesh);

}  // namespace geodesic

#endif  // GEODESIC_QUERY_H_
