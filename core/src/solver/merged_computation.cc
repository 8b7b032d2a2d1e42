#include "solver/merged_computation.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace geodesic {
namespace {

// More merged windows than this come of no surface but one where they wind. A
// face has one to three in the mean, and at a tolerance of 1e-5 at most ten on
// smooth meshes, sixteen on any other that was tried; a mesh of a few faces may
// have some more.
uint64_t MostMergedWindows(const Mesh& mesh) {
  constexpr uint64_t kByFace = 24;
  constexpr uint64_t kFew = 4096;
  return kByFace * mesh.face_count() + kFew;
}

// Passes polls on until there are too many windows since the first.
class UntilTooMany final : public Checkpoint {
 public:
  // The other checkpoint outlives this.
  UntilTooMany(uint64_t most, Checkpoint& other) : most_(most), other_(other) {}

  bool were_too_many() const { return were_too_many_; }

  absl::Status Poll(const Progress& progress) override {
    const uint64_t windows = progress.windows_propagated;
    if (!before_.has_value()) before_ = windows;
    were_too_many_ = windows - *before_ > most_;
    if (were_too_many_) return absl::AbortedError("too many merged windows");
    return other_.Poll(progress);
  }

 private:
  const uint64_t most_;
  Checkpoint& other_;
  std::optional<uint64_t> before_;
  bool were_too_many_ = false;
};

}  // namespace

MergedComputation::MergedComputation(const Mesh& mesh, const ValidQuery& query,
                                     std::unique_ptr<Computation> merged,
                                     StartExact start_exact)
    : mesh_(mesh),
      query_(*query),
      current_(std::move(merged)),
      start_exact_(std::move(start_exact)) {}

absl::Status MergedComputation::Advance(const Reach& reach,
                                        Checkpoint& checkpoint) {
  if (!is_exact_) {
    UntilTooMany until(MostMergedWindows(mesh_), checkpoint);
    absl::Status status = current_->Advance(reach, until);
    if (!until.were_too_many()) return status;
    if (status = BeginExactly(); !status.ok()) return status;
  }
  return current_->Advance(reach, checkpoint);
}

DistanceField MergedComputation::Field() const {
  DistanceField field = current_->Field();
  SolveStatistics& all = field.statistics;
  all.iterations += given_up_.iterations;
  all.windows_created += given_up_.windows_created;
  all.windows_propagated += given_up_.windows_propagated;
  all.pseudo_source_events += given_up_.pseudo_source_events;
  all.solve_seconds += given_up_.solve_seconds;
  all.peak_wavefront = std::max(all.peak_wavefront, given_up_.peak_wavefront);
  all.peak_windows = std::max(all.peak_windows, given_up_.peak_windows);
  all.peak_solver_bytes =
      std::max(all.peak_solver_bytes, given_up_.peak_solver_bytes);
  return field;
}

absl::Status MergedComputation::AddSource(const Source& source) {
  absl::Status status = current_->AddSource(source);
  if (status.ok()) query_.sources.push_back(source);
  return status;
}

absl::Status MergedComputation::BeginExactly() {
  const absl::StatusOr<ValidQuery> query = ValidQuery::Make(query_, mesh_);
  if (!query.ok()) return query.status();
  absl::StatusOr<std::unique_ptr<Computation>> exact =
      start_exact_(query->WithoutTolerance());
  if (!exact.ok()) return exact.status();
  given_up_ = current_->Field().statistics;
  current_ = *std::move(exact);
  is_exact_ = true;
  return absl::OkStatus();
}

}  // namespace geodesic
