// What questions that are answered by rows have in common: pairs (pairs.h),
// matrices and nearest targets (matrix.h).
//
// A question checks and plans itself once. Then each of its rows can be
// answered alone, in any order and on any thread, with the means that whoever
// asks has for that: KeptSearches (kept_searches.h), or others of their own.

#ifndef GEODESIC_ROWS_ROWS_H_
#define GEODESIC_ROWS_ROWS_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/approximate/prepared_method.h"
#include "geodesic/checkpoint.h"
#include "geodesic/computation.h"
#include "geodesic/distance_field.h"
#include "geodesic/landmarks.h"
#include "geodesic/path.h"
#include "geodesic/surface_point.h"
#include "geodesic/target_search.h"
#include "geodesic/valid_query.h"
#include "geodesic_types/algorithms.h"

namespace geodesic {

// The answer of a row.
struct DistanceRow {
  // The column of each value; empty in a dense row.
  std::vector<uint32_t> columns;
  // In the unit of the file; +infinity where no path leads.
  std::vector<double> values;
  // No value is farther from the truth than this part of it; 0 if they are
  // exact, up to rounding. Nothing is certified of approximate ones.
  double certified_error = 0;
  // Of the values, if they were asked for.
  std::vector<GeodesicPath> paths;

  // What it takes in memory. O(paths).
  uint64_t bytes() const;
};

// An approximate method that answers in place of the exact algorithms.
struct RowMethod {
  ApproximateMethod method;
  // Made of the question's mesh. Rows need it; a question is checked without.
  std::shared_ptr<const PreparedMethod> prepared;
};

// How a pair was answered.
enum class AnsweredBy {
  kSearch,  // of its own
  kField,   // computed for several pairs
  kKept,    // by a field that was there already
};

// What the rows about a mesh are answered with: its searches and landmarks, and
// the fields that are there. Thread-safe, since rows are answered in parallel.
class RowMeans {
 public:
  virtual ~RowMeans() = default;

  // Those there are; null: none.
  virtual std::shared_ptr<const Landmarks> landmarks() = 0;

  // Makes what is missing of `count` landmarks, on the calling thread. Where
  // they cannot be had, rows are answered without. False: they cannot be made
  // now; a later row asks again. Errors: the checkpoint's.
  virtual absl::StatusOr<bool> MakeLandmarks(uint32_t count,
                                             Checkpoint& checkpoint) = 0;

  // Searches were done that more landmarks make cheaper. DEFAULT: never mind.
  virtual void WantLandmarks() {}

  // Lends `work` a search on the mesh, and returns what it returns.
  virtual absl::Status WithSearch(
      const std::function<absl::Status(TargetSearch&)>& work) = 0;

  // Errors: as StartComputation.
  virtual absl::StatusOr<std::unique_ptr<Computation>> Start(
      const ValidQuery& query) = 0;

  // The whole exact field of one source, if it is there; null otherwise, which
  // is the DEFAULT. Pairs ask for it. REQUIRES: the source is on the mesh.
  virtual std::shared_ptr<const DistanceField> FindWhole(
      const SurfacePoint& source);

  // So many pairs were answered. DEFAULT: nobody counts.
  virtual void Count(AnsweredBy, uint64_t /*pairs*/) {}

  // Lends itself a search for one query. `landmarks` may be null.
  // Errors: as TargetSearch::Run.
  absl::StatusOr<TargetDistances> Search(const ValidQuery& query,
                                         const Landmarks* landmarks,
                                         Checkpoint& checkpoint);
};

}  // namespace geodesic

#endif  // GEODESIC_ROWS_ROWS_H_
