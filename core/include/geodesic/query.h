// What is asked of a mesh.

#ifndef GEODESIC_QUERY_H_
#define GEODESIC_QUERY_H_

#include <cstdint>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/algorithm.h"
#include "geodesic/mesh.h"

namespace geodesic {

// A vertex from which distances are measured. The field is
// d(x) = min over the sources of offset + geodesic distance to x.
struct Source {
  uint32_t vertex = 0;
  // In the unit of the mesh's file; finite, >= 0.
  double offset = 0;

  friend bool operator==(const Source&, const Source&) = default;
  friend auto operator<=>(const Source&, const Source&) = default;
};

struct Query {
  std::vector<Source> sources;
  Algorithm algorithm = kDefaultAlgorithm;
};

// Checks a query against the mesh with `vertex_count` vertices.
// Errors: INVALID_ARGUMENT naming the offender, e.g. "sources[3].vertex 991 is
// out of range: the mesh has 502 vertices".
absl::Status Validate(const Query& query, uint64_t vertex_count);

// The same question in one fixed form: sources sorted by vertex, of equal
// vertices only the least offset kept, -0 made 0. Two queries with the same
// field-defining content have equal canonical forms.
// REQUIRES: Validate(query, n).ok() for some n.
Query Canonicalize(Query query);

}  // namespace geodesic

#endif  // GEODESIC_QUERY_H_
