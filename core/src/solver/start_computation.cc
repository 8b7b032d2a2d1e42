#include "solver/start_computation.h"

#include <cmath>

#include "absl/strings/str_cat.h"
#include "solver/algorithm_table.h"

namespace geodesic {
namespace {

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

}  // namespace

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
  const StartFunction start = HasCurves(*query) ? CurveStart(query->algorithm)
                                                : PointStart(query->algorithm);
  return start(mesh, query, *tuning, observer);
}

absl::StatusOr<std::unique_ptr<Computation>> StartComputation(
    const Mesh& mesh, const ValidQuery& query, const SolveOptions& options) {
  return StartComputation(mesh, query, options, nullptr);
}

}  // namespace geodesic
