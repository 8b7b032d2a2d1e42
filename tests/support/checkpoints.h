// Checkpoints that watch a computation and stop it.

#ifndef GEODESIC_TESTS_SUPPORT_CHECKPOINTS_H_
#define GEODESIC_TESTS_SUPPORT_CHECKPOINTS_H_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/checkpoint.h"
#include "geodesic/settled_vertices.h"

namespace geodesic::test {

// Remembers what it was told; says stop at poll number `stop_at`, counted from
// 0, and goes on after that.
class RecordingCheckpoint final : public Checkpoint {
 public:
  explicit RecordingCheckpoint(uint64_t stop_at = UINT64_MAX)
      : stop_at_(stop_at) {}

  absl::Status Poll(const Progress& progress) override {
    polls_.push_back(progress);
    return polls_.size() == stop_at_ + 1 ? Stopped() : absl::OkStatus();
  }

  static absl::Status Stopped() { return absl::CancelledError("stopped here"); }

  // Their distances are not to be read.
  const std::vector<Progress>& polls() const { return polls_; }

 private:
  const uint64_t stop_at_;
  std::vector<Progress> polls_;
};

// Keeps vertices as they settle.
class SettledCheckpoint final : public Checkpoint {
 public:
  explicit SettledCheckpoint(const Mesh& mesh) : vertices_(mesh) {}

  absl::Status Poll(const Progress& progress) override {
    const size_t before = settled.size();
    for (const SettledVertex& vertex : vertices_.Collect(progress)) {
      settled.push_back(vertex);
    }
    if (std::isfinite(progress.settled_radius)) {
      early += settled.size() - before;
    }
    return absl::OkStatus();
  }

  std::vector<SettledVertex> settled;
  size_t early = 0;  // given out while the wavefront still moved

 private:
  SettledVertices vertices_;
};

// Stops what takes so many windows that something must have gone wrong.
class WindowLimit final : public Checkpoint {
 public:
  explicit WindowLimit(uint64_t most) : most_(most) {}

  absl::Status Poll(const Progress& progress) override {
    most_between_polls_ = std::max(most_between_polls_,
                                   progress.windows_propagated - propagated_);
    propagated_ = progress.windows_propagated;
    return propagated_ < most_
               ? absl::OkStatus()
               : absl::ResourceExhaustedError("windows without end");
  }

  // Windows that were propagated from one poll to the next.
  uint64_t most_between_polls() const { return most_between_polls_; }

 private:
  const uint64_t most_;
  uint64_t propagated_ = 0, most_between_polls_ = 0;
};

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_CHECKPOINTS_H_
