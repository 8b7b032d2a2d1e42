// Queries that are known to be valid.

#ifndef GEODESIC_TESTS_SUPPORT_QUERIES_H_
#define GEODESIC_TESTS_SUPPORT_QUERIES_H_

#include <variant>

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

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_QUERIES_H_
