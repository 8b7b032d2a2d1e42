// Meshes on their way from disk to memory: those who ask for the same one wait
// for one load, each may leave, and when the last has left it is called off.

#ifndef GEODESIC_SERVER_ENGINE_MESH_LOADS_H_
#define GEODESIC_SERVER_ENGINE_MESH_LOADS_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <stop_token>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/engine/byte_budget.h"
#include "server/engine/mesh_store.h"
#include "server/engine/scheduler.h"

namespace geodesic::server {

using MeshCallback = std::function<void(const absl::StatusOr<MeshHandle>&)>;

// Thread-safe. Nobody is called under a lock.
class MeshLoads {
 public:
  // What a load has before it runs: the mesh, if it has come meanwhile, or the
  // memory for it.
  struct Provision {
    MeshHandle mesh;
    ByteReservation arrays;  // and what else is gone when the mesh is there
    ByteReservation room;    // of the mesh store
  };

  // See Job::reserve.
  using ProvideFunction =
      std::function<absl::StatusOr<Provision>(const std::string& digest)>;
  // The work of one load, done in a job.
  using LoadFunction = std::function<absl::StatusOr<MeshHandle>(
      const std::string& digest, Provision provision,
      const std::stop_token& stop)>;

  // A place among those who wait.
  struct Seat {
    std::string digest;
    uint64_t number = 0;
  };

  // REQUIRES: `scheduler` outlives the object and has no job left when it goes.
  MeshLoads(Scheduler& scheduler, ProvideFunction provide, LoadFunction load)
      : scheduler_(scheduler),
        provide_(std::move(provide)),
        load_(std::move(load)) {}

  // Starts to load the mesh unless that is being done. `done` is called once,
  // from the job, unless the waiter leaves before; perhaps already before this
  // returns.
  // The load is a job of the client who asked first (see Requester).
  // Errors: as Scheduler::Submit; `done` is then not called.
  absl::StatusOr<Seat> Join(const std::string& digest, MeshCallback done,
                            const std::string& client);

  // Does nothing when the load has ended.
  void Leave(const Seat& seat);

  // Loads that wait or run.
  size_t size() const;

 private:
  struct Load {
    std::map<uint64_t, MeshCallback> waiters;
    Scheduler::JobId job;
    uint64_t number = 0;  // tells it from an earlier one of the same mesh
  };

  absl::Status Provide(const std::string& digest, Provision& provision) const;
  void End(const std::string& digest, uint64_t number,
           const absl::StatusOr<MeshHandle>& result);

  Scheduler& scheduler_;
  const ProvideFunction provide_;
  const LoadFunction load_;

  // Taken before the scheduler's.
  mutable std::mutex mutex_;
  // Guarded by mutex_:
  std::map<std::string, Load> loads_;  // by digest
  uint64_t next_number_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESH_LOADS_H_
