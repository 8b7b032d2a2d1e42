// Short lists of windows that have crossed a face, kept to be compared with
// those that come to their half-edge later.
//
// Lists forget what has crossed. Where wavefronts meet along a line of edges
// (all meridians of a sphere do, around its pole), windows that crossed the
// line come a round late to the edges beyond. They lose there, to windows that
// are gone, by too little for a filter to see, and follow the wavefront as far
// as it goes. MMP's rule, which forgets nothing, trims them away.
//
// To keep all lists takes more than it saves on most meshes. So those of every
// sixteenth half-edge are kept, of more on small meshes; once late windows
// often lose all that they hold there, those of every half-edge are.

#ifndef GEODESIC_SOLVER_RULES_PASSED_WINDOWS_H_
#define GEODESIC_SOLVER_RULES_PASSED_WINDOWS_H_

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "geodesic/mesh.h"
#include "solver/windows/window_blocks.h"

namespace geodesic {

class PassedWindows {
 public:
  // Longer lists are not kept.
  static constexpr size_t kMost = 4;

  explicit PassedWindows(uint32_t half_edges)
      : log_sample_(LogSampleOf(half_edges)),
        lists_((half_edges >> log_sample_) + 1),
        half_edges_(half_edges) {}

  // Where the list of h is kept, null in it if there is none; nullptr if h is
  // not of the sample. Threads may use different half-edges at once.
  WindowBlock** At(HalfEdge h) {
    const uint32_t others = (uint32_t{1} << log_sample_) - 1;
    return (h & others) != 0 ? nullptr : &lists_[h >> log_sample_];
  }

  // So many windows came late to half-edges whose list is kept, and lost all
  // that they held to it.
  void Count(uint64_t late, uint64_t lost) {
    if (log_sample_ == 0) return;
    late_ += late;
    lost_ += lost;
    if (late_ < kDecided) return;
    if (lost_ > late_ * kOften) KeepAll();
    late_ = lost_ = 0;
  }

  uint64_t bytes() const { return lists_.capacity() * sizeof(void*); }

 private:
  static constexpr uint32_t kMostLogSample = 4;
  static constexpr uint32_t kLeastSample = 4096;
  // Late windows of the sample that decide, and the part that has to lose.
  static constexpr uint64_t kDecided = 128;
  static constexpr double kOften = 0.5;

  static uint32_t LogSampleOf(uint32_t half_edges) {
    return std::min<uint32_t>(std::bit_width(half_edges / kLeastSample),
                              kMostLogSample);
  }

  void KeepAll() {
    std::vector<WindowBlock*> lists(half_edges_);
    for (HalfEdge h = 0; h < half_edges_; h += 1 << log_sample_) {
      lists[h] = lists_[h >> log_sample_];
    }
    lists_ = std::move(lists);
    log_sample_ = 0;
  }

  uint32_t log_sample_;
  std::vector<WindowBlock*> lists_;
  uint32_t half_edges_;
  uint64_t late_ = 0, lost_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_PASSED_WINDOWS_H_
