// A query that was checked against a mesh. Every computation starts from one,
// so each question is checked once.

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
// them (surface_point.h), no offset is -0, its algorithm is the one that runs,
// and it has a tolerance only where that algorithm can make use of it. Sources
// and targets keep their order.
//
// The algorithm that runs may differ from the one that was asked for. Chen and
// Han's rule (one angle, one split) needs windows that end at pseudo-sources
// and rays that meet when they are followed back. MMP's rule takes its place
// where that does not hold: if a source is a curve; if not all sources are
// vertices, unless the only source is a point and the algorithm is not ch; and
// on meshes with edges of three faces or more, or with faces without area,
// where rays coincide (docs/algorithm.md, 6, 13 and 16). Lists (fwp-list) give
// way to it for curves and for faces without area alone.
//
// It is valid for the mesh that it was made for only. Copies share their
// content, so they cost O(1). Immutable, and so thread-safe.
class ValidQuery {
 public:
  // Errors: INVALID_ARGUMENT naming the offender, e.g. "sources[3].vertex 991
  // is out of range: the mesh has 502 vertices, numbered from 0", with its path
  // (field_path.h).
  // O(sources + points of curves + targets).
  static absl::StatusOr<ValidQuery> Make(Query query, const Mesh& mesh);

  const Query& operator*() const { return *query_; }
  const Query* operator->() const { return query_.get(); }

  // The same question with its sources in one fixed order: points first,
  // sorted, then curves as they come. Of equal points only the one with the
  // least offset stays. Questions that differ only in the order of their points
  // become equal.
  SortedQuery Sorted() const;

  // The same question with or without a trace.
  ValidQuery WithTrace(bool trace) const;
  // The same without targets at vertices, whose distances every field has.
  ValidQuery WithoutVertexTargets() const;
  // The same without targets and without a trace.
  ValidQuery DistancesAlone() const;
  // The same without a tolerance, so that it is answered exactly.
  ValidQuery WithoutTolerance() const;
  // One source alone. The algorithm is the one that runs for that source, which
  // decides about the tolerance that was asked for, too.
  // REQUIRES: the mesh of Make.
  ValidQuery OfSource(uint32_t source, const Mesh& mesh) const;
  // One target alone.
  ValidQuery OfTarget(uint32_t target) const;
  // From all targets to each source, without offsets and without a trace.
  // REQUIRES: the mesh of Make; there are targets, and no source is a curve.
  ValidQuery Transposed(const Mesh& mesh) const;

  // Both compare the canonical forms.
  friend auto operator<=>(const ValidQuery& a, const ValidQuery& b) {
    return *a <=> *b;
  }
  friend bool operator==(const ValidQuery& a, const ValidQuery& b) {
    return *a == *b;
  }

 private:
  // What was asked for; query_ has what comes of it.
  struct Asked {
    Algorithm algorithm;
    double tolerance;
  };

  ValidQuery(Query query, Asked asked);

  std::shared_ptr<const Query> query_;
  Asked asked_;
};

// A query with its sources in one fixed order.
struct SortedQuery {
  ValidQuery query;
  // For each source of `query`, its number in the unsorted query. Of equal ones
  // it is the first.
  std::vector<uint32_t> numbers;
};

}  // namespace geodesic

#endif  // GEODESIC_VALID_QUERY_H_
