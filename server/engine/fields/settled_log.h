// The vertices of one computation in order of distance, as they become final.
// The solver appends while any number of readers read.

#ifndef GEODESIC_SERVER_ENGINE_FIELDS_SETTLED_LOG_H_
#define GEODESIC_SERVER_ENGINE_FIELDS_SETTLED_LOG_H_

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/checkpoint.h"
#include "geodesic/settled_vertices.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/jobs/job_checkpoint.h"
#include "server/locks/mutex.h"

namespace geodesic::server {

// Thread-safe; one writer.
class SettledLog {
 public:
  // Of a field on `mesh`.
  explicit SettledLog(std::shared_ptr<const Mesh> mesh)
      : mesh_(std::move(mesh)), collector_(*mesh_) {}

  // The bytes of `vertices` entries.
  static uint64_t BytesFor(uint64_t vertices) {
    return vertices * sizeof(SettledVertex);
  }

  // Holds `memory`, which is enough for `vertices` entries.
  void Reserve(ByteReservation memory, size_t vertices);

  // Appends the vertices that have become final since the last call. O(V).
  void Append(const Progress& progress);

  size_t size() const;

  // Up to `count` entries from number `begin` on.
  std::vector<SettledVertex> Read(size_t begin, size_t count) const;

 private:
  const std::shared_ptr<const Mesh> mesh_;
  SettledVertices collector_;  // the writer's

  mutable Mutex mutex_;
  std::vector<SettledVertex> entries_ ABSL_GUARDED_BY(mutex_);
  ByteReservation memory_ ABSL_GUARDED_BY(mutex_);
};

// Keeps the log up to date while a solver runs.
class SettledCheckpoint final : public Checkpoint {
 public:
  // Vertices beyond `radius` are left out. The references outlive it.
  SettledCheckpoint(JobCheckpoint& next, SettledLog& log, double radius)
      : next_(next), log_(log), radius_(radius) {}

  absl::Status Poll(const Progress& progress) override;

 private:
  JobCheckpoint& next_;
  SettledLog& log_;
  const double radius_;
  uint64_t next_scan_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELDS_SETTLED_LOG_H_
