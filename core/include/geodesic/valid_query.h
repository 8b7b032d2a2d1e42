// A query that was checked against a mesh. Everything that is computed starts
// from one, so that each question is checked once.

#ifndef GEODESIC_VALID_QUERY_H_
#define GEODESIC_VALID_QUERY_H_

#include <compare>
#include <cstdint>
#include <memory>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/mesh.h"
#include "geodesic/query.h"

namespace geodesic {

struct SortedQuery;

// A query in canonical form: its points lie on the lowest elements that hold
// them (surface_point.h), no offset is -0, and its algorithm is the one that
// runs. Sources and targets are those that were given, in the same order.
//
// Chen and Han's rule (one angle, one split) needs windows that end at
// pseudo-sources and rays that meet when they are followed back; where there
// are several sources and not all are vertices, or curves, or edges of three
// faces or more, the MMP rule takes its place. So it does on meshes with faces
// without area, where rays coincide (docs/algorithm.md, 6, 13 and 16).
//
// Only for the mesh that it was made for. Copies share their content: O(1).
class ValidQuery {
 public:
  // Errors: INVALID_ARGUMENT naming the offender, e.g. "sources[3].vertex 991
  // is out of range: the mesh has 502 vertices, numbered from 0", with its path
  // (field_path.h). O(sources, points of curves and targets).
  static absl::StatusOr<ValidQuery> Make(Query query, const Mesh& mesh);

  const Query& operator*() const { return *query_; }
  const Query* operator->() const { return query_.get(); }

  // The same question with its sources in one fixed order: points first and in
  // order, of equal ones only the least offset, then curves as they come.
  // Questions that differ in the order of their points alone are equal then.
  SortedQuery Sorted() const;

  // Parts of the question, and the same one with a trace or without:
  ValidQuery WithTrace(bool trace) const;
  // Distances at vertices are in every field.
  ValidQuery WithoutVertexTargets() const;
  // Neither targets nor a trace.
  ValidQuery DistancesAlone() const;
  // One source alone. The algorithm is the one that runs for that source.
  // REQUIRES: the mesh of Make.
  ValidQuery OfSource(uint32_t source, const Mesh& mesh) const;

  // By the canonical form.
  friend auto operator<=>(const ValidQuery& a, const ValidQuery& b) {
    return *a <=> *b;
  }
  friend bool operator==(const ValidQuery& a, const ValidQuery& b) {
    return *a == *b;
  }

 private:
  ValidQuery(Query query, Algorithm asked);

  std::shared_ptr<const Query> query_;
  Algorithm asked_;  // which may give way to query_->algorithm
};

struct SortedQuery {
  ValidQuery query;
  // Which source of the unsorted query each of its sources is; of equal ones
  // the first.
  std::vector<uint32_t> numbers;
};

}  // namespace geodesic

#endif  // GEODESIC_VALID_QUERY_H_
