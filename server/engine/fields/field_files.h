// The finished fields on disk and in a tier shared with other servers: a
// second, larger FieldCache that outlives the process. A field that is lost
// here is computed again.

#ifndef GEODESIC_SERVER_ENGINE_FIELDS_FIELD_FILES_H_
#define GEODESIC_SERVER_ENGINE_FIELDS_FIELD_FILES_H_

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "server/engine/fields/field_cache.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/meshes/mesh_library.h"
#include "server/locks/mutex.h"
#include "server/store/blob_tiers.h"

namespace geodesic::server {

// Thread-safe. Put, Load and EraseMesh wait for disk and shared tier; Find does
// not.
class FieldFiles {
 public:
  // A field, and where it was found.
  struct Stored {
    DistanceField field;
    BlobTier from = BlobTier::kDisk;
  };

  // Fields that another `version` of the program computed are not found.
  // REQUIRES: `blobs` outlives the object.
  FieldFiles(BlobTiers& blobs, std::string version)
      : blobs_(blobs), version_(std::move(version)) {}

  // The key of a field on disk that should answer the question, judged without
  // reading it; see FieldCache::Find.
  std::optional<FieldKey> Find(const FieldKey& key, const FieldReach& reach);

  // Keeps the field unless the disk has one that reaches as far.
  // Errors: as BlobTiers::Keep.
  absl::Status Put(const FieldKey& key, const Mesh& mesh,
                   const DistanceField& field);

  // Puts a field that was computed here into the shared tier. Waits for
  // nothing.
  void Share(const FieldKey& key, const Mesh& mesh, const DistanceField& field);

  // The field of this very key, on its mesh, from the disk or else from the
  // shared tier. It may yet reach less far than its targets ask. A traced field
  // names half-edges, so it is usable only while they are numbered as they
  // were.
  // Errors: NOT_FOUND, DATA_LOSS (set aside), UNAVAILABLE, RESOURCE_EXHAUSTED.
  absl::StatusOr<Stored> Load(const FieldKey& key, const FieldReach& reach,
                              const Mesh& mesh);

  // Drops the fields of a mesh from the disk. On a disk that is read-only they
  // stay; they are still right, because meshes are named by their content.
  void EraseMesh(const std::string& digest);

  bool has_disk() const { return blobs_.has_disk(); }
  bool has_shared() const { return blobs_.has_shared(); }

 private:
  std::string NameOf(const FieldKey& key) const;

  BlobTiers& blobs_;
  const std::string version_;
};

// Writes fields to disk when the scheduler has nothing else to do. Waiting
// fields and meshes are not pinned; those evicted before their turn are not
// written. Has at most one job at a time. Thread-safe.
class FieldWriter {
 public:
  // A field is removed from disk if its mesh is gone from `meshes`.
  // REQUIRES: the references outlive the object, and `scheduler` has no job
  // left when it is destroyed.
  FieldWriter(FieldFiles& files, Scheduler& scheduler, MeshLibrary& meshes)
      : files_(files), scheduler_(scheduler), meshes_(meshes) {}

  // Does nothing when too many wait already: a field can be computed again.
  void Enqueue(const FieldKey& key, const MeshHandle& mesh,
               const FieldHandle& field);

 private:
  struct Item {
    FieldKey key;
    std::weak_ptr<const ResidentMesh> mesh;
    std::weak_ptr<const DistanceField> field;
  };

  // REQUIRES: waiting_ is not empty.
  void SubmitJob() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  void WriteOne();

  FieldFiles& files_;
  Scheduler& scheduler_;
  MeshLibrary& meshes_;

  Mutex mutex_;
  std::deque<Item> waiting_ ABSL_GUARDED_BY(mutex_);
  bool has_job_ ABSL_GUARDED_BY(mutex_) = false;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELDS_FIELD_FILES_H_
