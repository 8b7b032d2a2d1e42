#include "solver/start_computation.h"

#include <cmath>
#include <memory>
#include <type_traits>

#include "absl/strings/str_cat.h"
#include "geodesic/solve.h"
#include "geodesic_types/algorithms.h"
#include "geodesic_types/field_path.h"
#include "solver/accuracy.h"
#include "solver/merged_computation.h"
#include "solver/propagation.h"
#include "solver/queues/binary_heap.h"
#include "solver/queues/fifo.h"
#include "solver/queues/fwp_buckets.h"
#include "solver/queues/label_correcting.h"
#include "solver/rules/ch_rule.h"
#include "solver/rules/list_rule.h"
#include "solver/rules/merging_rule.h"
#include "solver/rules/mmp_rule.h"
#include "solver/windows/mixed_origin.h"

namespace geodesic {
namespace {

// Which rule and which queue an algorithm is. Type erasure happens here, once
// per query. Curves are asked of algorithms that trim only (ValidQuery sees to
// it).
template <typename OriginType>
std::unique_ptr<Computation> Start(const Mesh& mesh, const ValidQuery& query,
                                   const Tuning& tuning,
                                   WindowObserver* observer) {
  switch (query->algorithm) {
#define GEODESIC_START(id, name, Rule, Queue, with_trimming, summary) \
  case Algorithm::k##id:                                              \
    if constexpr (std::is_same_v<OriginType, Origin> ||               \
                  Algorithm::k##id == Algorithm::k##with_trimming) {  \
      return std::make_unique<Propagation<Rule, Queue, OriginType>>(  \
          mesh, query, tuning, observer);                             \
    }                                                                 \
    break;
    GEODESIC_ALGORITHMS(GEODESIC_START)
#undef GEODESIC_START
  }
  return nullptr;
}

}  // namespace

absl::Status CheckRadius(double radius) {
  if (radius >= 0) return absl::OkStatus();
  return InvalidField("radius", absl::StrCat("radius is ", radius,
                                             "; it must be a number >= 0"));
}

absl::StatusOr<Tuning> TuningFor(const Mesh& mesh,
                                 const SolveOptions& options) {
  if (!(options.bucket_width > 0) || !std::isfinite(options.bucket_width)) {
    return absl::InvalidArgumentError(
        "options.bucket_width is not a finite number > 0");
  }
  if (options.max_batch == 0) {
    return absl::InvalidArgumentError("options.max_batch is 0");
  }
  if (options.threads == 0 || options.threads > kMostSolveThreads) {
    return absl::InvalidArgumentError(
        absl::StrCat("options.threads ", options.threads, " is not in [1, ",
                     kMostSolveThreads, "]"));
  }
  // l = h / sqrt(n), section 4.1. A mesh without extent has no h; any width
  // serves its distances, which are all 0 or offsets.
  const double h = mesh.mean_edge_length() > 0 ? mesh.mean_edge_length() : 1;
  return Tuning{
      .bucket_width = options.bucket_width * h /
                      std::sqrt(static_cast<double>(mesh.face_count())),
      .max_batch = options.max_batch,
      .adaptive_batch = options.adaptive_batch,
      .threads = options.threads};
}

uint64_t PlannedSolverBytes(const Mesh& mesh, const ValidQuery& query) {
  const uint64_t per_point =
      sizeof(double) + (query->trace ? sizeof(Arrival) : 0);
  return mesh.resident_bytes() / 4 +
         (mesh.vertex_count() + query->targets.size()) * per_point;
}

absl::StatusOr<std::unique_ptr<Computation>> StartComputation(
    const Mesh& mesh, const ValidQuery& query, const SolveOptions& options,
    WindowObserver* observer) {
  absl::StatusOr<Tuning> tuning = TuningFor(mesh, options);
  if (!tuning.ok()) return tuning.status();
  if (query->tolerance > 0) {
    return std::make_unique<MergedComputation>(
        mesh, query,
        std::make_unique<
            Propagation<MergingRule, FwpBuckets, Origin, WithinTolerance>>(
            mesh, query, *tuning, observer),
        [&mesh, options, observer](const ValidQuery& exact) {
          return StartComputation(mesh, exact, options, observer);
        });
  }
  return HasCurves(*query) ? Start<MixedOrigin>(mesh, query, *tuning, observer)
                           : Start<Origin>(mesh, query, *tuning, observer);
}

absl::StatusOr<std::unique_ptr<Computation>> StartComputation(
    const Mesh& mesh, const ValidQuery& query, const SolveOptions& options) {
  return StartComputation(mesh, query, options, nullptr);
}

absl::StatusOr<DistanceField> Solve(const Mesh& mesh, const ValidQuery& query,
                                    const SolveOptions& options,
                                    Checkpoint& checkpoint) {
  absl::StatusOr<std::unique_ptr<Computation>> computation =
      StartComputation(mesh, query, options);
  if (!computation.ok()) return computation.status();
  if (absl::Status status = (*computation)->Advance({}, checkpoint);
      !status.ok()) {
    return status;
  }
  return (*computation)->Field();
}

absl::StatusOr<DistanceField> Solve(const Mesh& mesh, const Query& query,
                                    const SolveOptions& options,
                                    Checkpoint& checkpoint) {
  const absl::StatusOr<ValidQuery> valid = ValidQuery::Make(query, mesh);
  if (!valid.ok()) return valid.status();
  return Solve(mesh, *valid, options, checkpoint);
}

}  // namespace geodesic
