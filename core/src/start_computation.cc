#include "start_computation.h"

#include <cmath>

#include "anchors.h"
#include "propagation.h"
#include "queues/binary_heap.h"
#include "queues/fifo.h"
#include "queues/fwp_buckets.h"
#include "queues/label_correcting.h"
#include "rules/ch_rule.h"
#include "rules/mmp_rule.h"

namespace geodesic {
namespace {

using Start = std::unique_ptr<Computation> (*)(const Mesh&, const Query&,
                                               const QueueTuning&,
                                               WindowObserver*);

template <template <typename> typename Rule, WindowQueue Queue>
std::unique_ptr<Computation> StartWith(const Mesh& mesh, const Query& query,
                                       const QueueTuning& tuning,
                                       WindowObserver* observer) {
  return std::make_unique<Propagation<Rule, Queue>>(mesh, query, tuning,
                                                    observer);
}

// Rule x queue; the type is erased here, once per query.
Start StartOf(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::kFwpCh:
      return StartWith<IchRule, FwpBuckets>;
    case Algorithm::kFwpMmp:
      return StartWith<MmpRule, FwpBuckets>;
    case Algorithm::kIch:
      return StartWith<IchRule, BinaryHeap>;
    case Algorithm::kMmp:
      return StartWith<MmpRule, BinaryHeap>;
    case Algorithm::kLcCh:
      return StartWith<IchRule, LabelCorrecting>;
    case Algorithm::kLcMmp:
      return StartWith<MmpRule, LabelCorrecting>;
    case Algorithm::kCh:
      return StartWith<ChRule, Fifo>;
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

absl::StatusOr<std::unique_ptr<Computation>> StartComputation(
    const Mesh& mesh, const Query& query, const SolveOptions& options,
    WindowObserver* observer) {
  if (absl::Status status = Validate(query, mesh); !status.ok()) return status;
  absl::StatusOr<QueueTuning> tuning = TuningFor(mesh, options);
  if (!tuning.ok()) return tuning.status();
  return StartOf(query.algorithm)(mesh, WithCanonicalPoints(query, mesh),
                                  *tuning, observer);
}

absl::StatusOr<std::unique_ptr<Computation>> StartComputation(
    const Mesh& mesh, const Query& query, const SolveOptions& options) {
  return StartComputation(mesh, query, options, nullptr);
}

}  // namespace geodesic
