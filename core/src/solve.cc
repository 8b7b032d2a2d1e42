#include "geodesic/solve.h"

#include <chrono>
#include <cmath>

#include "propagation.h"
#include "queues/binary_heap.h"
#include "queues/fifo.h"
#include "queues/fwp_buckets.h"
#include "queues/label_correcting.h"
#include "rules/ch_rule.h"
#include "rules/mmp_rule.h"

namespace geodesic {
namespace {

using Run = absl::StatusOr<DistanceField> (*)(const Mesh&, const Query&,
                                              const QueueTuning&, Checkpoint&);

template <template <typename> typename Rule, WindowQueue Queue>
absl::StatusOr<DistanceField> RunWith(const Mesh& mesh, const Query& query,
                                      const QueueTuning& tuning,
                                      Checkpoint& checkpoint) {
  return Propagation<Rule, Queue>(mesh, query, tuning).Run(checkpoint);
}

// Rule x queue; the type is erased here, once per query.
Run RunOf(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::kFwpCh:
      return RunWith<IchRule, FwpBuckets>;
    case Algorithm::kFwpMmp:
      return RunWith<MmpRule, FwpBuckets>;
    case Algorithm::kIch:
      return RunWith<IchRule, BinaryHeap>;
    case Algorithm::kMmp:
      return RunWith<MmpRule, BinaryHeap>;
    case Algorithm::kLcCh:
      return RunWith<IchRule, LabelCorrecting>;
    case Algorithm::kLcMmp:
      return RunWith<MmpRule, LabelCorrecting>;
    case Algorithm::kCh:
      return RunWith<ChRule, Fifo>;
  }
  return nullptr;
}

absl::StatusOr<QueueTuning> TuningFor(const Mesh& mesh,
                                      const SolveOptions& options) {
  if (!(options.bucket_width > 0) || !std::isfinite(options.bucket_width)) {
    return absl::InvalidArgumentError(
        "options.bucket_width is not a finite number > 0");
  }
  if (options.max_batch == 0) {
    return absl::InvalidArgumentError("options.max_batch is 0");
  }
  // l = h / sqrt(n), section 4.1. A mesh without extent has no h; any width
  // serves its distances, which are all 0 or offsets.
  const double h = mesh.mean_edge_length() > 0 ? mesh.mean_edge_length() : 1;
  return QueueTuning{
      .bucket_width = options.bucket_width * h /
                      std::sqrt(static_cast<double>(mesh.face_count())),
      .max_batch = options.max_batch,
      .adaptive_batch = options.adaptive_batch};
}

}  // namespace

absl::StatusOr<DistanceField> Solve(const Mesh& mesh, const Query& query,
                                    const SolveOptions& options,
                                    Checkpoint& checkpoint) {
  const auto start = std::chrono::steady_clock::now();
  if (absl::Status status = Validate(query, mesh.vertex_count());
      !status.ok()) {
    return status;
  }
  absl::StatusOr<QueueTuning> tuning = TuningFor(mesh, options);
  if (!tuning.ok()) return tuning.status();
  absl::StatusOr<DistanceField> field =
      RunOf(query.algorithm)(mesh, query, *tuning, checkpoint);
  if (field.ok()) {
    field->statistics.solve_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
            .count();
  }
  return field;
}

}  // namespace geodesic
