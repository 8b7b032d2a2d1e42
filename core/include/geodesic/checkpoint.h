// How a running solver reports progress and learns of cancellation, deadlines
// and memory budgets.

#ifndef GEODESIC_CHECKPOINT_H_
#define GEODESIC_CHECKPOINT_H_

#include <cstdint>
#include <span>

#include "absl/status/status.h"

namespace geodesic {

// A snapshot of a running computation.
struct Progress {
  // Every distance <= settled_radius is final (file units). Never decreases
  // within one field.
  double settled_radius = 0;
  // Vertices relaxed at least once; with `vertices` it makes a fair progress
  // bar, monotone within one field: where several are computed, or one takes
  // the place of a search, it begins anew.
  uint64_t vertices_reached = 0;
  uint64_t vertices = 0;
  uint64_t live_windows = 0;
  uint64_t windows_propagated = 0;
  // Bytes the solver holds beyond the mesh.
  uint64_t solver_bytes = 0;
  // The distances so far, one per vertex. Times `unit` they are in file units;
  // those up to settled_radius are final; with a tolerance they are lower
  // bounds, twice as far from the truth at the most. Valid during the call of
  // Poll only.
  std::span<const double> distances = {};
  double unit = 1;
};

// Asked by a computation whether to go on.
class Checkpoint {
 public:
  virtual ~Checkpoint() = default;

  // The solver calls this from its own thread, once before the first window and
  // then at least every few thousand windows or faces around a vertex (well
  // under 10 ms apart). A status that is not OK stops the solver, which returns
  // that status.
  virtual absl::Status Poll(const Progress& progress) = 0;
};

// Never stops anything.
class NoCheckpoint final : public Checkpoint {
 public:
  absl::Status Poll(const Progress&) override { return absl::OkStatus(); }
};

}  // namespace geodesic

#endif  // GEODESIC_CHECKPOINT_H_
