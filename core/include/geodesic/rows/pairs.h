// Distances of many pairs of points, and the paths between them.
//
//   KeptSearches searches(*mesh);
//   auto question = PairQuestion::Make(*mesh, pairs, {}, searches, 1);
//   for (uint64_t row = 0; row < (*question)->rows().size(); ++row) {
//     absl::StatusOr<DistanceRow> found = (*question)->Answer(row, checkpoint);
//     // found->values[i] is the distance of pair found->columns[i].
//   }
//
// Pairs are searched one by one; many that share an end get a field from there.

#ifndef GEODESIC_ROWS_PAIRS_H_
#define GEODESIC_ROWS_PAIRS_H_

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"
#include "geodesic/rows/rows.h"
#include "geodesic/surface_point.h"
#include "geodesic/valid_query.h"
#include "geodesic_types/algorithms.h"
#include "geodesic_types/places.h"

namespace geodesic {

// What is asked of all pairs alike.
struct PairOptions {
  // Whether rows have paths, too, from source to target. They are then in order
  // of the pairs.
  bool paths = false;
  // As Query::tolerance; 0 with a method.
  double tolerance = 0;
  // If set, all ends are vertices, and there are no paths.
  std::optional<RowMethod> method = {};
};

// Pairs that are answered together.
struct PairRow {
  // An end that all pairs of the row have: a field from there answers them. If
  // there is none, each pair is searched.
  std::optional<SurfacePoint> shared;
  // Their numbers, ascending.
  std::vector<uint32_t> pairs;
};

// One question. Immutable, and thread-safe.
class PairQuestion {
 public:
  // Checks the pairs and plans their rows, of which about `threads` will be
  // answered at once. Equal questions have equal plans where searches cost the
  // same. O(n log n). REQUIRES: mesh and means outlive the question.
  // Errors: INVALID_ARGUMENT with the path (field_path.h) of the offender, e.g.
  // "pairs[3].target.vertex", "paths" or "tolerance".
  static absl::StatusOr<std::shared_ptr<const PairQuestion>> Make(
      const Mesh& mesh, std::vector<PointPair> pairs, PairOptions options,
      RowMeans& means, size_t threads);

  size_t pair_count() const { return pairs_.size(); }
  // Every pair is in one row. Rows are ordered by their first pair.
  const std::vector<PairRow>& rows() const { return rows_; }
  // That of exact searches.
  Algorithm algorithm() const { return algorithm_; }
  // So many are made by the first row that searches, if the searches are so
  // many that these pay.
  uint32_t landmarks() const { return landmarks_; }

  // The most bytes that one row takes, for its solver and for its values.
  uint64_t PlannedBytes() const;
  uint64_t RowBytes() const;

  // A sparse row: its columns are numbers of pairs. Costs a field, or a search
  // for each pair of the row. REQUIRES: the method, if there is one, is
  // prepared. Errors: the checkpoint's; what the means return.
  absl::StatusOr<DistanceRow> Answer(uint64_t row,
                                     Checkpoint& checkpoint) const;

 private:
  PairQuestion(const Mesh& mesh, std::vector<PointPair> pairs,
               PairOptions options, Algorithm algorithm, RowMeans& means);
  void Plan(size_t threads);

  // The distance of one point from another, or of one from several, as a query.
  ValidQuery QueryOf(const SurfacePoint& source,
                     std::vector<SurfacePoint> targets) const;
  // Of the pairs of a row that shares an end.
  std::vector<SurfacePoint> OtherEnds(const PairRow& row) const;

  // Makes landmarks if they are to be made and nobody has begun.
  absl::Status PrepareSearches(Checkpoint& checkpoint) const;
  absl::Status Search(const PairRow& row, Checkpoint& checkpoint,
                      DistanceRow& result) const;
  absl::Status Solve(const PairRow& row, Checkpoint& checkpoint,
                     DistanceRow& result) const;
  absl::Status Approximate(const PairRow& row, Checkpoint& checkpoint,
                           std::vector<double>& distances) const;

  const Mesh& mesh_;
  const std::vector<PointPair> pairs_;  // canonical
  const PairOptions options_;
  const Algorithm algorithm_;
  RowMeans& means_;
  std::vector<PairRow> rows_;
  uint32_t landmarks_ = 0;
  mutable std::atomic<bool> makes_landmarks_ = false;
};

}  // namespace geodesic

#endif  // GEODESIC_ROWS_PAIRS_H_
