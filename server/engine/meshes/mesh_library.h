// The meshes a server has; how they are uploaded, loaded and deleted.
//
// With a data folder, memory is a cache of the disk:
//   1. an upload is answered when its mesh is on disk;
//   2. a mesh in memory is on disk, except while it is dropped from both;
//   3. Await loads a mesh that is on disk but not in memory.
//
// With a shared tier, Await fetches a mesh that is not here from it.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_MESH_LIBRARY_H_
#define GEODESIC_SERVER_ENGINE_MESHES_MESH_LIBRARY_H_

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/base/limits.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/jobs/shared_jobs.h"
#include "server/engine/meshes/landmark_store.h"
#include "server/engine/meshes/mesh_catalogue.h"
#include "server/engine/meshes/mesh_files.h"
#include "server/engine/meshes/mesh_store.h"
#include "server/engine/meshes/mesh_upload.h"
#include "server/engine/meshes/method_store.h"
#include "server/engine/meshes/shared_meshes.h"

namespace geodesic::server {

struct UploadResult {
  MeshDescription mesh;
  // Whether the server had it before.
  bool already_resident = false;
};
using UploadCallback = std::function<void(const absl::StatusOr<UploadResult>&)>;
using UploadJobs = SharedJobs<uint64_t, UploadResult>;  // each of its own key

// Loads of meshes from disk or the shared tier; all who ask for one mesh share
// one load.
using MeshLoads = SharedJobs<std::string, MeshHandle>;
using MeshCallback = std::function<void(const absl::StatusOr<MeshHandle>&)>;

struct MissingMeshes {
  std::vector<std::string> mesh_digests;
  std::vector<FileKey> files;
  struct KnownFile {
    FileKey file;
    std::string mesh_digest;
  };
  std::vector<KnownFile> known_files;
};

struct MeshPage {
  std::vector<MeshDescription> meshes;
  // Empty on the last page.
  std::string next_token;
};

// Thread-safe. No call waits for a job or the disk. Jobs belong to the `client`
// of the call that starts them (see Requester).
class MeshLibrary {
 public:
  // `removed` is called for each mesh that is gone for good, deleted or lost by
  // the disk. It may wait for the disk.
  // REQUIRES: `limits`, `scheduler` and `clock` outlive the object, and
  // `scheduler` has no job left when it is destroyed.
  MeshLibrary(const Limits& limits, const Clock& clock, Scheduler& scheduler,
              std::shared_ptr<ByteBudget> upload_memory,
              std::function<void(const std::string& digest)> removed);

  // From now on keeps meshes in `files`, which outlives the object. Call before
  // any other method.
  void Attach(MeshFiles& files);

  // From now on asks `shared`, which outlives the object, for meshes that are
  // not here, and has it keep those that come. Call before any other method.
  void Attach(SharedMeshes& shared) { shared_ = &shared; }

  // Errors: INVALID_ARGUMENT naming a malformed digest, or the number of items
  // when there are more than 1000.
  absl::StatusOr<MissingMeshes> FindMissing(
      const std::vector<std::string>& mesh_digests,
      const std::vector<FileKey>& files);

  // Errors: as MeshUpload::Start; RESOURCE_EXHAUSTED when the memory or disk
  // for such an upload can never be had; UNAVAILABLE while shutting down.
  absl::StatusOr<std::unique_ptr<MeshUpload>> StartUpload(UploadHeader header);

  // Parses, builds and keeps the mesh in a job, which waits for its memory as
  // Job::reserve says. The job calls `done` once, unless it is cancelled while
  // it waits. If the file is known, the job looks for the mesh on the disk;
  // without a data folder `done` is called from here and the ticket is empty.
  // The job calls `built` before `done`, even if nobody waits any more; what
  // `built` captured is freed when the job has ended.
  // Errors, here or in `done`: INVALID_ARGUMENT (bytes missing; a malformed
  // file; a refused mesh; another digest than expected); RESOURCE_EXHAUSTED;
  // UNAVAILABLE.
  absl::StatusOr<UploadJobs::Ticket> FinishUpload(
      std::unique_ptr<MeshUpload> upload, UploadCallback done,
      const std::string& client = {},
      std::function<void(const UploadResult&)> built = nullptr);

  // Drops the upload's job, or makes it stop soon and keep nothing. Its
  // callback is not called.
  void CancelUpload(const UploadJobs::Ticket& upload) {
    uploads_.Leave(upload);
  }

  // Returns a mesh in memory and marks it as used.
  // Errors: INVALID_ARGUMENT: malformed digest, naming `field`; NOT_FOUND: not
  // resident.
  absl::StatusOr<MeshHandle> Get(const std::string& digest,
                                 std::string_view field = "digest");

  // Describes a mesh in memory or on disk and marks it as used.
  // Errors: INVALID_ARGUMENT: malformed digest; NOT_FOUND: in neither.
  absl::StatusOr<MeshDescription> Describe(const std::string& digest);
  // Whether it is in either, also if it came from the shared tier and the disk
  // could not take it.
  bool Contains(const std::string& digest) {
    return catalogue_->Contains(digest) || store_.Holds(digest);
  }

  // Whether Await may bring a mesh that is not here.
  bool has_shared_tier() const { return shared_ != nullptr; }

  // Calls `done` with the mesh in memory. If it is there already, that happens
  // from here and the ticket is empty; otherwise from the job that loads it,
  // which waits for its memory as Job::reserve says.
  // Errors, here or in `done`: NOT_FOUND; RESOURCE_EXHAUSTED (no memory, at
  // once if it can never be had; the queue is full); UNAVAILABLE (shutting
  // down; the disk cannot be read).
  absl::StatusOr<MeshLoads::Ticket> Await(const std::string& digest,
                                          MeshCallback done,
                                          const std::string& client = {});
  void Leave(const MeshLoads::Ticket& ticket) { loads_.Leave(ticket); }

  // `page_size` 0 means 100; a size above 1000 counts as 1000.
  // Errors: INVALID_ARGUMENT: negative size or malformed token.
  absl::StatusOr<MeshPage> List(int page_size, const std::string& token);

  // Drops the mesh; running jobs keep it. With a data folder a job does so, and
  // `done` is called when the mesh is gone from disk; otherwise at once.
  // Errors, here or in `done`: as Describe; RESOURCE_EXHAUSTED (the queue is
  // full); UNAVAILABLE (shutting down; the disk cannot be written).
  absl::Status Delete(const std::string& digest,
                      std::function<void(const absl::Status&)> done,
                      const std::string& client = {});

  uint64_t meshes_built() const { return meshes_built_; }
  uint64_t meshes_loaded() const { return meshes_loaded_; }  // from disk
  // From the shared tier.
  uint64_t meshes_fetched() const { return meshes_fetched_; }
  const MeshStore& store() const { return store_; }
  // Of meshes in memory; they go with their meshes.
  LandmarkStore& landmarks() { return landmarks_; }
  const LandmarkStore& landmarks() const { return landmarks_; }
  MethodStore& methods() { return methods_; }
  const MethodStore& methods() const { return methods_; }
  const MeshLoads& loads() const { return loads_; }

 private:
  // An upload whose bytes have come. Its job parses them, builds the mesh, then
  // keeps it. Each step begins when its memory is available, because the need
  // of a build is only known once the file is parsed.
  struct MeshBuild {
    std::unique_ptr<MeshUpload> upload;
    ByteReservation room;  // of the mesh store, once it is parsed
    std::optional<ResidentMesh> built;
    // A mesh that the server has; the next step looks whether it is on disk.
    std::string known;
  };
  // Before a load runs it has the mesh, if that has come meanwhile, or memory
  // for it.
  struct MeshLoad {
    std::string digest;
    MeshHandle mesh;
    std::optional<SharedMesh> found;   // once the tier is known to have it
    ByteReservation arrays;            // and the build's temporary memory
    ByteReservation room;              // of the mesh store
    std::optional<TriangleSoup> read;  // from the disk
    std::optional<ResidentMesh> fetched;

    bool has_begun() const { return read.has_value() || fetched.has_value(); }
  };

  MeshHandle FindResident(const std::string& digest);
  std::optional<MeshDescription> Find(const std::string& digest);
  // Adds what the mesh, which is in memory, has there beside it.
  void DescribeMemory(uint64_t resident_bytes, MeshDescription& mesh) const;
  std::optional<std::string> FindFile(const FileKey& file);

  // Whether the memory to build a mesh can ever be had.
  absl::Status CheckMemory(uint64_t vertices, uint64_t faces) const;
  // CheckMemory, and whether the disk can ever hold the mesh.
  absl::Status CheckCapacity(uint64_t vertices, uint64_t faces) const;

  // The mesh of the upload's file, if it is known and the expected one.
  std::optional<UploadResult> FindUploaded(const MeshUpload& upload);
  // Takes the memory for the next step. See Job::reserve.
  absl::Status Reserve(MeshBuild& build);
  absl::Status ReserveForMesh(MeshBuild& build);
  // Goes on as far as there is memory. If the result is empty, call Reserve and
  // run it again. No mesh is kept once `checkpoint` has failed.
  absl::StatusOr<std::optional<UploadResult>> Run(MeshBuild& build,
                                                  Checkpoint& checkpoint);
  // Whether the mesh that the server has is on disk; empty if it is not.
  absl::StatusOr<std::optional<UploadResult>> FindKnown(MeshBuild& build);
  absl::StatusOr<std::optional<UploadResult>> Build(MeshBuild& build,
                                                    Checkpoint& checkpoint);
  absl::StatusOr<UploadResult> Keep(MeshBuild& build);
  void AddFile(const MeshUpload& upload);

  bool WaitsForDisk(const MeshLoad& load) const;
  absl::Status Reserve(MeshLoad& load);
  absl::Status Reserve(MeshLoad& load, uint64_t vertices, uint64_t faces);
  // If the result is empty, call Reserve and run it again.
  absl::StatusOr<std::optional<MeshHandle>> Run(MeshLoad& load,
                                                Checkpoint& checkpoint);
  absl::StatusOr<MeshHandle> BuildRead(MeshLoad& load,
                                       const MeshDescription& mesh,
                                       Checkpoint& checkpoint);
  // Looks for the mesh in the shared tier.
  absl::Status FindShared(MeshLoad& load);
  absl::StatusOr<ResidentMesh> Fetch(MeshLoad& load, Checkpoint& checkpoint);
  absl::StatusOr<MeshHandle> KeepFetched(MeshLoad& load);

  // Keeps the mesh in memory. If the disk has lost the mesh meanwhile, it is
  // dropped and `value` of the result is null.
  MeshStore::Inserted Keep(ResidentMesh mesh, ByteReservation room);
  absl::Status Erase(const std::string& digest);

  const Limits& limits_;
  Scheduler& scheduler_;
  const std::shared_ptr<ByteBudget> upload_memory_;
  const std::function<void(const std::string&)> removed_;
  LandmarkStore landmarks_;
  MethodStore methods_;
  MeshStore store_;
  MeshCatalogue* catalogue_ = &store_;
  SharedMeshes* shared_ = nullptr;
  UploadJobs uploads_;
  MeshLoads loads_;

  std::atomic<uint64_t> next_upload_ = 0;
  std::atomic<uint64_t> meshes_built_ = 0;
  std::atomic<uint64_t> meshes_loaded_ = 0;
  std::atomic<uint64_t> meshes_fetched_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_MESH_LIBRARY_H_
