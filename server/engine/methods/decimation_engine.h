// Decimates meshes for those who draw them.

#ifndef GEODESIC_SERVER_ENGINE_METHODS_DECIMATION_ENGINE_H_
#define GEODESIC_SERVER_ENGINE_METHODS_DECIMATION_ENGINE_H_

#include <atomic>
#include <cstdint>
#include <memory>

#include "absl/status/statusor.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/base/limits.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/jobs/shared_jobs.h"
#include "server/engine/meshes/decimation_store.h"
#include "server/engine/meshes/mesh_library.h"

namespace geodesic::server {

// Equal decimations that are asked for at the same time are one.
using DecimationJobs = SharedJobs<DecimationKey, DecimationHandle>;

// Thread-safe. No call waits for a job.
class DecimationEngine {
 public:
  // REQUIRES: the references outlive the engine, and `scheduler` has no job
  // left when it is destroyed.
  DecimationEngine(const Limits& limits, const Clock& clock,
                   Scheduler& scheduler,
                   std::shared_ptr<ByteBudget> solver_memory,
                   MeshLibrary& meshes);

  // Tells `waiter` the triangles of geodesic::Decimate. If they are kept, that
  // happens from here and the ticket is empty; otherwise a job makes them, or
  // one that is under way is joined.
  // Errors, here or in `waiter.done`: INVALID_ARGUMENT naming max_faces if it
  // is 0; RESOURCE_EXHAUSTED (no memory for the work or for what comes of it;
  // the queue is full); UNAVAILABLE. After an error here nobody waits.
  absl::StatusOr<DecimationJobs::Ticket> Decimate(
      const MeshHandle& mesh, uint64_t max_faces,
      Waiter<DecimationHandle> waiter, const Requester& requester);
  // Ends a wait. If it was the last, the work stops soon.
  void Leave(const DecimationJobs::Ticket& ticket) { jobs_.Leave(ticket); }

  // How many were made since the start.
  uint64_t made() const { return made_; }

 private:
  absl::StatusOr<DecimationHandle> Run(const MeshHandle& mesh,
                                       uint64_t max_faces,
                                       Checkpoint& checkpoint);

  const std::shared_ptr<ByteBudget> solver_memory_;
  MeshLibrary& meshes_;
  DecimationJobs jobs_;
  std::atomic<uint64_t> made_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_METHODS_DECIMATION_ENGINE_H_
