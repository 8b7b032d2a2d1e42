// Asks the caller's checkpoint every so often whether to go on.

#ifndef GEODESIC_POLYGONS_PACE_H_
#define GEODESIC_POLYGONS_PACE_H_

#include <cstdint>

#include "absl/status/status.h"
#include "geodesic/checkpoint.h"

namespace geodesic {

class Pace {
 public:
  // `checkpoint` may be null: then nothing stops the work.
  explicit Pace(Checkpoint* checkpoint) : checkpoint_(checkpoint) {}

  // Whether to go on after so many more steps, each of up to a microsecond.
  bool Goes(uint32_t steps = 1) {
    steps_ += steps;
    if (steps_ < kBetweenPolls) return true;
    // A work that was stopped stays so.
    if (checkpoint_ != nullptr && status_.ok()) {
      status_ = checkpoint_->Poll({});
    }
    if (!status_.ok()) return false;
    steps_ = 0;
    return true;
  }

  const absl::Status& status() const { return status_; }

 private:
  static constexpr uint32_t kBetweenPolls = 1 << 12;

  Checkpoint* const checkpoint_;
  absl::Status status_;
  uint32_t steps_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_POLYGONS_PACE_H_
