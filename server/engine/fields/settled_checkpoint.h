// Keeps a SettledLog up to date while a solver runs.

#ifndef GEODESIC_SERVER_ENGINE_FIELDS_SETTLED_CHECKPOINT_H_
#define GEODESIC_SERVER_ENGINE_FIELDS_SETTLED_CHECKPOINT_H_

#include <algorithm>
#include <cstdint>

#include "absl/status/status.h"
#include "geodesic/checkpoint.h"
#include "server/engine/fields/settled_log.h"
#include "server/engine/jobs/job_checkpoint.h"

namespace geodesic::server {

class SettledCheckpoint final : public Checkpoint {
 public:
  // Vertices beyond `radius` are left out. The references outlive it.
  SettledCheckpoint(JobCheckpoint& next, SettledLog& log, double radius)
      : next_(next), log_(log), radius_(radius) {}

  absl::Status Poll(const Progress& progress) override {
    absl::Status status = next_.Poll(progress);
    // A look at every vertex is paid for by a few windows a vertex. Before the
    // first window not even the sources have their distances.
    if (progress.windows_propagated < next_scan_ ||
        progress.settled_radius <= 0) {
      return status;
    }
    next_scan_ = progress.windows_propagated +
                 kWindowsPerVertex * progress.distances.size();
    // What is final goes out even if the solver has to stop now.
    Append(progress);
    return status;
  }

 private:
  static constexpr uint64_t kWindowsPerVertex = 4;

  void Append(Progress progress) {
    progress.settled_radius = std::min(progress.settled_radius, radius_);
    const size_t before = log_.size();
    log_.Append(progress);
    if (log_.size() > before) next_.Publish(progress);
  }

  JobCheckpoint& next_;
  SettledLog& log_;
  const double radius_;
  uint64_t next_scan_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELDS_SETTLED_CHECKPOINT_H_
