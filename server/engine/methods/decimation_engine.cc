#include "server/engine/methods/decimation_engine.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geodesic/decimate.h"
#include "geodesic_types/field_path.h"

namespace geodesic::server {

DecimationEngine::DecimationEngine(const Limits& limits, const Clock& clock,
                                   Scheduler& scheduler,
                                   std::shared_ptr<ByteBudget> solver_memory,
                                   MeshLibrary& meshes)
    : solver_memory_(std::move(solver_memory)),
      meshes_(meshes),
      jobs_(scheduler, clock, limits.progress_interval) {}

absl::StatusOr<DecimationJobs::Ticket> DecimationEngine::Decimate(
    const MeshHandle& mesh, uint64_t max_faces, Waiter<DecimationHandle> waiter,
    const Requester& requester) {
  if (max_faces == 0) {
    return InvalidField("max_faces", "max_faces is 0; it must be at least 1");
  }
  // All limits that change nothing are one.
  max_faces = std::min<uint64_t>(max_faces, mesh->mesh->face_count());
  const DecimationKey key = {mesh->digest, max_faces};
  if (DecimationHandle kept = meshes_.decimations().Find(key)) {
    waiter.done(std::move(kept));
    return DecimationJobs::Ticket();
  }
  const uint64_t planned = EstimateDecimateBytes(*mesh->mesh);
  absl::Status fits = solver_memory_->CheckCapacity(planned);
  if (fits.ok()) fits = meshes_.decimations().CheckCapacity(max_faces);
  if (!fits.ok()) return fits;
  waiter.account = requester.account;
  return jobs_.Join(key, std::move(waiter), SolvePriority(requester.is_batch),
                    [&] {
                      return WorkInMemory<DecimationHandle>(
                          solver_memory_, planned, requester.client,
                          [this, mesh, max_faces](Checkpoint& checkpoint) {
                            return Run(mesh, max_faces, checkpoint);
                          });
                    });
}

absl::StatusOr<DecimationHandle> DecimationEngine::Run(const MeshHandle& mesh,
                                                       uint64_t max_faces,
                                                       Checkpoint& checkpoint) {
  DecimationStore& store = meshes_.decimations();
  const DecimationKey key = {mesh->digest, max_faces};
  if (DecimationHandle kept = store.Find(key)) return kept;
  absl::StatusOr<std::vector<Triangle>> made =
      geodesic::Decimate(*mesh->mesh, max_faces, checkpoint);
  if (!made.ok()) return made.status();
  ++made_;
  absl::StatusOr<DecimationHandle> kept = store.Insert(key, *std::move(made));
  // A mesh that went before now found nothing to take along.
  if (!meshes_.store().Holds(mesh->digest)) store.EraseMesh(mesh->digest);
  return kept;
}

}  // namespace geodesic::server
