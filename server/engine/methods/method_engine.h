// Prepares meshes for approximate methods, and for exact distances of pairs by
// landmarks.

#ifndef GEODESIC_SERVER_ENGINE_METHODS_METHOD_ENGINE_H_
#define GEODESIC_SERVER_ENGINE_METHODS_METHOD_ENGINE_H_

#include <atomic>
#include <compare>
#include <cstdint>
#include <functional>
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
#include "server/engine/searches/landmark_maker.h"

namespace geodesic::server {

// What is to be prepared of a mesh: a method, or its landmarks.
struct Preparation {
  std::string mesh_digest;
  std::optional<MethodChoice> method;  // nothing: landmarks

  friend auto operator<=>(const Preparation&, const Preparation&) = default;
};

// The mesh, and the method if it was one.
using Prepared = MethodHandle;
// Equal preparations that are asked for at the same time are one.
using MethodJobs = SharedJobs<Preparation, Prepared>;

// Thread-safe. No call waits for a job or the disk.
class MethodEngine {
 public:
  // REQUIRES: the references outlive the engine, and `scheduler` has no job
  // left when it is destroyed.
  MethodEngine(const Limits& limits, const Clock& clock, Scheduler& scheduler,
               std::shared_ptr<ByteBudget> solver_memory, MeshLibrary& meshes,
               LandmarkMaker& landmarks);

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
  absl::StatusOr<MethodJobs::Ticket> Prepare(
      const MeshHandle& mesh, const std::optional<MethodChoice>& method,
      Waiter<Prepared> waiter, const Requester& requester);
  // Ends a wait. If it was the last, the work stops soon.
  void Leave(const MethodJobs::Ticket& ticket) { jobs_.Leave(ticket); }

  // Drops what is prepared of a mesh. Waits for the disk, if graphs are kept
  // there.
  void EraseMesh(const std::string& digest);

  // Methods that were prepared and graphs that came from disk, since the start.
  uint64_t made() const { return made_; }
  uint64_t loaded() const { return loaded_; }

 private:
  absl::StatusOr<Prepared> Run(const MeshHandle& mesh,
                               const std::optional<MethodChoice>& method,
                               Checkpoint& checkpoint);
  absl::StatusOr<std::shared_ptr<const PreparedMethod>> Make(
      const ResidentMesh& mesh, const MethodChoice& choice,
      Checkpoint& checkpoint);

  const Limits& limits_;
  const Clock& clock_;
  Scheduler& scheduler_;
  const std::shared_ptr<ByteBudget> solver_memory_;
  MeshLibrary& meshes_;
  LandmarkMaker& landmarks_;
  GraphFiles* files_ = nullptr;  // null: graphs are kept in memory alone
  MethodJobs jobs_;
  std::atomic<uint64_t> made_ = 0;
  std::atomic<uint64_t> loaded_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_METHODS_METHOD_ENGINE_H_
