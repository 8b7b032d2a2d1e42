// Prepares meshes for approximate methods.

#ifndef GEODESIC_SERVER_ENGINE_METHODS_METHOD_ENGINE_H_
#define GEODESIC_SERVER_ENGINE_METHODS_METHOD_ENGINE_H_

#include <atomic>
#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/approximate/prepare.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/base/limits.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/jobs/shared_jobs.h"
#include "server/engine/meshes/mesh_library.h"
#include "server/engine/meshes/method_store.h"
#include "server/engine/methods/graph_files.h"

namespace geodesic::server {

// Of which mesh what is to be prepared.
struct Preparation {
  std::string mesh_digest;
  MethodChoice method;

  friend auto operator<=>(const Preparation&, const Preparation&) = default;
};

// Equal preparations that are asked for at the same time are one.
using MethodJobs = SharedJobs<Preparation, MethodHandle>;

// Thread-safe. No call waits for a job or the disk.
class MethodEngine {
 public:
  // REQUIRES: the references outlive the engine, and `scheduler` has no job
  // left when it is destroyed.
  MethodEngine(const Limits& limits, const Clock& clock, Scheduler& scheduler,
               std::shared_ptr<ByteBudget> solver_memory, MeshLibrary& meshes);

  // From now on also keeps graphs in `files`, which outlives the object. Call
  // before any other method.
  void Attach(GraphFiles& files) { files_ = &files; }

  // The method, if it is prepared.
  std::optional<MethodHandle> Find(const MeshHandle& mesh,
                                   const MethodChoice& choice) {
    return meshes_.methods().Find(mesh, choice);
  }

  // Starts to prepare a mesh, or joins who does.
  // Errors, here or in `waiter.done`: as PrepareMethod; RESOURCE_EXHAUSTED (no
  // memory for the work or for what comes of it; the queue is full);
  // UNAVAILABLE. After an error here nobody waits.
  absl::StatusOr<MethodJobs::Ticket> Prepare(const MeshHandle& mesh,
                                             const MethodChoice& method,
                                             Waiter<MethodHandle> waiter,
                                             const Requester& requester);
  // Ends a wait. If it was the last, the work stops soon.
  void Leave(const MethodJobs::Ticket& ticket) { jobs_.Leave(ticket); }

  // Drops what is prepared of a mesh. Waits for the disk, if graphs are kept
  // there.
  void EraseMesh(const std::string& digest);

  // Methods that were prepared and graphs that came from disk, since the start.
  uint64_t made() const { return made_; }
  uint64_t loaded() const { return loaded_; }

 private:
  // What to do for those who wait for a method.
  SharedWork<MethodHandle> Work(const MeshHandle& mesh,
                                const MethodChoice& method,
                                uint64_t planned_bytes,
                                const std::string& client);
  // A graph that is kept; nothing if there is none.
  absl::StatusOr<std::optional<MethodHandle>> Load(const MeshHandle& mesh,
                                                   const MethodChoice& method);
  absl::StatusOr<MethodHandle> Run(const MeshHandle& mesh,
                                   const MethodChoice& method,
                                   Checkpoint& checkpoint);
  absl::StatusOr<std::shared_ptr<const PreparedMethod>> Make(
      const ResidentMesh& mesh, const MethodChoice& choice,
      Checkpoint& checkpoint);
  // From when it is there on; `begin`: since when it was made or read.
  absl::StatusOr<MethodHandle> Keep(const MeshHandle& mesh,
                                    const MethodChoice& method,
                                    std::shared_ptr<const PreparedMethod> made,
                                    TimePoint begin);

  const Limits& limits_;
  const Clock& clock_;
  Scheduler& scheduler_;
  const std::shared_ptr<ByteBudget> solver_memory_;
  MeshLibrary& meshes_;
  GraphFiles* files_ = nullptr;  // null: graphs are kept in memory alone
  MethodJobs jobs_;
  std::atomic<uint64_t> made_ = 0;
  std::atomic<uint64_t> loaded_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_METHODS_METHOD_ENGINE_H_
