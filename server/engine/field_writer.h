// Writes fields to disk when nothing else is to do.

#ifndef GEODESIC_SERVER_ENGINE_FIELD_WRITER_H_
#define GEODESIC_SERVER_ENGINE_FIELD_WRITER_H_

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>

#include "geodesic/distance_field.h"
#include "server/engine/field_cache.h"
#include "server/engine/field_files.h"
#include "server/engine/field_key.h"
#include "server/engine/mesh_store.h"
#include "server/engine/scheduler.h"

namespace geodesic::server {

// Fields and meshes wait here unpinned: what is evicted first is not written.
// At most one job of the scheduler's is this object's. Thread-safe.
class FieldWriter {
 public:
  // REQUIRES: both outlive the object, and `scheduler` has no job left when it
  // goes.
  FieldWriter(FieldFiles& files, Scheduler& scheduler)
      : files_(files), scheduler_(scheduler) {}

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

  std::mutex mutex_;
  // Guarded by mutex_:
  std::deque<Item> waiting_;
  bool has_job_ = false;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELD_WRITER_H_
