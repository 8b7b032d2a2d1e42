#include "server/engine/pairs/pair_engine.h"

#include <utility>

#include "geodesic/rows/pairs.h"

namespace geodesic::server {

PairEngine::PairEngine(const Limits& limits, Scheduler& scheduler,
                       SoloJobs& jobs, MeshLibrary& meshes,
                       SearchEngine& searches, FieldEngine& fields)
    : limits_(limits),
      scheduler_(scheduler),
      jobs_(jobs),
      meshes_(meshes),
      searches_(searches),
      fields_(fields) {}

absl::StatusOr<PairCall> PairEngine::Compute(PairRequest request,
                                             std::function<void()> on_row) {
  absl::StatusOr<MeshHandle> resident =
      meshes_.Get(request.mesh_digest, "mesh_digest");
  if (!resident.ok()) return resident.status();
  // A method knows the mesh that it was made of, not an equal one.
  const MeshHandle mesh =
      request.method.has_value() ? request.method->mesh : *resident;
  const auto work =
      std::make_shared<PairWork>(searches_, fields_, totals_, mesh);
  const absl::StatusOr<std::shared_ptr<const PairQuestion>> made =
      PairQuestion::Make(*mesh->mesh, std::move(request.pairs),
                         {.paths = request.paths,
                          .tolerance = request.tolerance,
                          .method = RowMethodOf(request.method)},
                         *work, limits_.max_concurrent_jobs);
  if (!made.ok()) return made.status();
  absl::Status status = CheckPrepared(request.method);
  if (!status.ok()) return status;
  const PairQuestion& question = **made;
  PairCall call{.mesh = mesh,
                .algorithm = question.algorithm(),
                .pair_count = question.pair_count(),
                .work = work};
  if (request.method.has_value()) call.algorithm = request.method->choice;
  const bool is_batch = request.requester.is_batch;
  RowJobs plan{.client = request.requester.client,
               .account = std::move(request.requester.account),
               // What takes one job is answered at once, like any question.
               .priority = question.rows().size() == 1 ? SolvePriority(is_batch)
                                                       : RowPriority(is_batch),
               .deadline = request.deadline,
               .planned_bytes = question.PlannedBytes(),
               .row_bytes = question.RowBytes()};
  call.rows = std::make_shared<RowPipeline>(
      jobs_, scheduler_, std::move(plan), question.rows().size(),
      [work, question = *made](uint64_t row, Checkpoint& checkpoint,
                               ByteReservation memory) {
        return Charge(question->Answer(row, checkpoint), std::move(memory));
      },
      std::move(on_row));
  if (status = call.rows->Start(); !status.ok()) return status;
  return call;
}

}  // namespace geodesic::server
