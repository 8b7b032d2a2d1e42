#include "geodesic/parallel_chen_han.h"

#include <algorithm>
#include <variant>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic/computation.h"
#include "geodesic/solve_options.h"
#include "solver/propagation.h"
#include "solver/queues/fifo.h"
#include "solver/rules/pch_rule.h"
#include "solver/start_computation.h"

namespace geodesic {
namespace {

// Ends what outgrows its memory.
class Bounded final : public Checkpoint {
 public:
  Bounded(uint64_t most_bytes, Checkpoint& checkpoint)
      : most_bytes_(most_bytes), checkpoint_(checkpoint) {}

  absl::Status Poll(const Progress& progress) override {
    if (progress.solver_bytes > most_bytes_) {
      return absl::ResourceExhaustedError(absl::StrCat(
          "pch needs ", progress.solver_bytes, " bytes by now, more than ",
          most_bytes_,
          ": its windows have no bound; ask fwp-list or another algorithm"));
    }
    return checkpoint_.Poll(progress);
  }

 private:
  const uint64_t most_bytes_;
  Checkpoint& checkpoint_;
};

bool IsVertex(const Source& source) {
  const auto* point = std::get_if<SurfacePoint>(&source.place);
  return point != nullptr && std::holds_alternative<VertexPoint>(*point);
}

absl::Status Check(const Mesh& mesh, const ValidQuery& query) {
  if (!std::ranges::all_of(query->sources, IsVertex)) {
    return absl::InvalidArgumentError(
        "pch starts from vertices; ask another algorithm");
  }
  if (mesh.HasNonManifoldEdges() || mesh.HasCollapsedFaces()) {
    return absl::InvalidArgumentError(
        "pch: the mesh has faces without area or edges of three faces or more; "
        "ask fwp-mmp");
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<DistanceField> SolveByLevels(
    const Mesh& mesh, const ValidQuery& query,
    const ParallelChenHanOptions& options, Checkpoint& checkpoint) {
  if (absl::Status status = Check(mesh, query); !status.ok()) return status;
  const absl::StatusOr<Tuning> tuning =
      TuningFor(mesh, {.threads = options.threads});
  if (!tuning.ok()) return tuning.status();
  Propagation<PchRule, Fifo> computation(mesh, query, *tuning, nullptr);
  Bounded bounded(options.most_bytes, checkpoint);
  absl::Status status = computation.Advance({}, bounded);
  if (!status.ok()) return status;
  DistanceField field = computation.Field();
  field.algorithm = Algorithm::kCh;
  return field;
}

}  // namespace geodesic
