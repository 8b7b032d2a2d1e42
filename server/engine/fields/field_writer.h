// Writes fields to disk when nothing else is to do.

#ifndef GEODESIC_SERVER_ENGINE_FIELDS_FIELD_WRITER_H_
#define GEODESIC_SERVER_ENGINE_FIELDS_FIELD_WRITER_H_

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>

#include "geodesic/distance_field.h"
#include "server/engine/fields/field_cache.h"
#include "server/engine/fields/field_files.h"
#include "server/engine/fields/field_key.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/meshes/mesh_library.h"

namespace geodesic::server {

// Fields and meshes wait here unpinned: what is evicted first is not written.
// At most one job of the scheduler's is this object's. Thread-safe.
class FieldWriter {
 public:
  // No field stays on disk whose mesh is gone from `meshes`.
  // REQUIRES: all outlive the object, and `scheduler` has no job left when it
  // goes.
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

  // REQUIRES: mutex_ held, waiting_ not empty.
  void SubmitJob();
  void WriteOne();

  FieldFiles& files_;
  Scheduler& scheduler_;
  MeshLibrary& meshes_;

  std::mutex mutex_;
  // Guarded by mutex_:
  std::deque<Item> waiting_;
  bool has_job_ = false;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELDS_FIELD_WRITER_H_
