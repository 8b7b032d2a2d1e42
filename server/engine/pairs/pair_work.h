// Answers the rows of a plan of pairs.

#ifndef GEODESIC_SERVER_ENGINE_PAIRS_PAIR_WORK_H_
#define GEODESIC_SERVER_ENGINE_PAIRS_PAIR_WORK_H_

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/solve_options.h"
#include "server/engine/fields/field_engine.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/meshes/mesh_store.h"
#include "server/engine/meshes/method_store.h"
#include "server/engine/pairs/pair_plan.h"
#include "server/engine/searches/search_engine.h"

namespace geodesic::server {

// How pairs were answered.
struct PairCounts {
  uint64_t searched = 0;     // by a search of their own
  uint64_t from_fields = 0;  // by a field that was computed for several
  uint64_t from_cache = 0;   // by a field that was there already

  uint64_t all() const { return searched + from_fields + from_cache; }
};

// Thread-safe.
class PairCounter {
 public:
  PairCounts counts() const { return {searched, from_fields, from_cache}; }

  std::atomic<uint64_t> searched = 0;
  std::atomic<uint64_t> from_fields = 0;
  std::atomic<uint64_t> from_cache = 0;
};

// One question. Const functions are thread-safe.
struct PairWork {
  // What answers questions. They outlive the work.
  const StartFunction& start;
  const SolveOptions& options;
  FieldEngine& fields;
  SearchEngine& searches;
  PairCounter& totals;  // of all questions

  MeshHandle mesh;
  Algorithm algorithm = kDefaultAlgorithm;  // of exact searches
  std::optional<MethodHandle> method;       // if distances are approximate
  std::vector<PointPair> pairs;             // canonical
  bool paths = false;                       // wanted, too
  double tolerance = 0;                     // valid
  std::vector<PairRow> rows;
  // So many are made first, if searches are so many that these pay.
  uint32_t landmarks = 0;
  mutable std::atomic<bool> makes_landmarks = false;
  mutable PairCounter answered;

  // The most memory that one row takes, for its solver and for its values.
  // REQUIRES: there is a pair.
  uint64_t PlannedBytes() const;
  uint64_t RowBytes() const;

  // A sparse row: its columns are numbers of pairs. Errors: the checkpoint's.
  absl::StatusOr<MatrixRow> Answer(uint64_t row, Checkpoint& checkpoint,
                                   ByteReservation memory) const;

 private:
  // The distance of one point from another, or of one from several, as a query.
  ValidQuery QueryOf(const SurfacePoint& source,
                     std::vector<SurfacePoint> targets) const;
  absl::Status Search(const std::vector<uint32_t>& numbers,
                      Checkpoint& checkpoint, MatrixRow& row) const;
  absl::Status Solve(const PairRow& row, Checkpoint& checkpoint,
                     MatrixRow& result) const;
  absl::Status Approximate(const PairRow& row, Checkpoint& checkpoint,
                           std::vector<double>& distances) const;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_PAIRS_PAIR_WORK_H_
