// The meshes a server has: those in memory and, if it has a data folder, those
// on disk.
//
// With a data folder, memory is a cache of the disk:
//   1. an upload is answered when its mesh is on disk;
//   2. a mesh in memory is on disk, but while it is being dropped from both;
//   3. a mesh on disk that is not in memory comes back by Await.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_MESH_LIBRARY_H_
#define GEODESIC_SERVER_ENGINE_MESHES_MESH_LIBRARY_H_

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/base/limits.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/jobs/shared_jobs.h"
#include "server/engine/meshes/mesh_description.h"
#include "server/engine/meshes/mesh_files.h"
#include "server/engine/meshes/mesh_store.h"
#include "server/engine/meshes/mesh_upload.h"

namespace geodesic::server {

// Meshes on their way from disk to memory: one load for all who ask.
using MeshLoads = SharedJobs<std::string, MeshHandle>;
using MeshCallback = std::function<void(const absl::StatusOr<MeshHandle>&)>;

struct UploadResult {
  MeshDescription mesh;
  // The server had it before.
  bool already_resident = false;
};

// Thread-safe.
class MeshLibrary {
 public:
  // REQUIRES: `scheduler` and `clock` outlive the object, and `scheduler` has
  // no job left when it goes.
  MeshLibrary(const Limits& limits, const Clock& clock, Scheduler& scheduler,
              std::shared_ptr<ByteBudget> upload_memory);

  // From now on keeps meshes in `files`, which outlives the object. Call
  // before all else. `removed` hears of each mesh that the disk no longer has
  // though nobody deleted it.
  void Attach(MeshFiles& files,
              std::function<void(const std::string& digest)> removed);

  // The mesh in memory, or null; marks it as used.
  MeshHandle FindResident(const std::string& digest);

  // What is known of a mesh wherever it is; marks it as used.
  std::optional<MeshDescription> Describe(const std::string& digest);
  bool Contains(const std::string& digest);
  // The digest of a mesh that is there and was uploaded as this file.
  std::optional<std::string> FindFile(const FileKey& file);

  // Up to `count` meshes in order of digest, from the first above `after`.
  std::vector<MeshDescription> List(const std::string& after,
                                    size_t count) const;

  // Calls `done` with the mesh in memory: at once if it is there, otherwise
  // from the job that loads it, which waits for its memory as Job::reserve
  // says. Returns the ticket of who has to wait.
  // Errors, here or in `done`: NOT_FOUND; RESOURCE_EXHAUSTED (no memory, at
  // once if it can never be had; the queue is full); UNAVAILABLE (shutting
  // down; the disk cannot be read).
  absl::StatusOr<std::optional<MeshLoads::Ticket>> Await(
      const std::string& digest, MeshCallback done, const std::string& client);
  void Leave(const MeshLoads::Ticket& ticket) { loads_.Leave(ticket); }

  // If the upload's file is known and is the expected one, what came of it.
  std::optional<UploadResult> FindUploaded(const MeshUpload& upload);

  // The rest of what an upload needs on its way (MeshBuild).

  // Whether it can ever become a mesh that is kept, as far as its header tells.
  // Errors: RESOURCE_EXHAUSTED with the figures.
  absl::Status CheckCapacity(const UploadHeader& header) const;
  // The same of a mesh.
  absl::Status CheckCapacity(const std::string& digest, uint64_t vertices,
                             uint64_t faces) const;

  // The mesh of this digest that is there, known as the upload's file from now
  // on.
  std::optional<UploadResult> FindBuilt(const std::string& digest,
                                        const MeshUpload& upload);

  // What a build takes of the upload memory, beside its arrays.
  static uint64_t BytesToBuild(uint64_t vertices, uint64_t faces);

  // Makes room in memory for a mesh.
  // Errors: RESOURCE_EXHAUSTED, without a retry hint if there never will be
  // any.
  absl::StatusOr<ByteReservation> ReserveResident(const std::string& digest,
                                                  uint64_t vertices,
                                                  uint64_t faces);

  // Checks and keeps the mesh of an upload. Not for a thread that must not
  // wait. Errors: INVALID_ARGUMENT, RESOURCE_EXHAUSTED, UNAVAILABLE; what
  // `checkpoint` says, and then the mesh is not kept.
  absl::StatusOr<UploadResult> Build(TriangleSoup soup,
                                     const std::string& digest,
                                     const MeshUpload& upload,
                                     ByteReservation room,
                                     Checkpoint& checkpoint);

  // Waits for the disk, if there is one.
  // Errors: NOT_FOUND; UNAVAILABLE (it cannot be removed from the disk).
  absl::Status Erase(const std::string& digest);

  bool is_durable() const { return files_ != nullptr; }
  uint64_t meshes_built() const { return meshes_built_; }
  uint64_t meshes_loaded() const { return meshes_loaded_; }
  const MeshStore& store() const { return store_; }
  const MeshLoads& loads() const { return loads_; }

 private:
  // Whether the memory to build a mesh can ever be had.
  absl::Status CheckMemory(const std::string& digest, uint64_t vertices,
                           uint64_t faces) const;
  void RememberFile(const MeshUpload& upload, const std::string& digest);
  // What a load has before it runs: the mesh, if it has come meanwhile, or the
  // memory for it.
  struct LoadMemory {
    MeshHandle mesh;
    ByteReservation arrays;  // and what else is gone when the mesh is there
    ByteReservation room;    // of the mesh store
  };
  absl::Status Reserve(const std::string& digest, LoadMemory& memory);
  absl::StatusOr<MeshHandle> Load(const std::string& digest, LoadMemory& memory,
                                  Checkpoint& checkpoint);
  // Keeps the mesh in memory, unless the disk has lost it meanwhile: then
  // `mesh` of the result is null.
  MeshStore::Inserted Keep(ResidentMesh mesh, ByteReservation room);

  const std::shared_ptr<ByteBudget> upload_memory_;
  MeshFiles* files_ = nullptr;
  MeshStore store_;
  MeshLoads loads_;

  std::atomic<uint64_t> meshes_built_ = 0;
  std::atomic<uint64_t> meshes_loaded_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_MESH_LIBRARY_H_
