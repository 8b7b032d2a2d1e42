// Windows by 32-bit number, recycled.

#ifndef GEODESIC_SOLVER_WINDOWS_WINDOW_POOL_H_
#define GEODESIC_SOLVER_WINDOWS_WINDOW_POOL_H_

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace geodesic {

// Numbers are dense and reused, most recently freed first, so that a live
// wavefront stays in cache. Windows lie in chunks that never move: growing
// copies nothing, and references stay valid until Free.
template <typename Window>
class WindowPool {
 public:
  uint32_t Allocate(const Window& window) {
    peak_ = std::max(peak_, ++live_);
    uint32_t id = used_;
    if (!free_.empty()) {
      id = free_.back();
      free_.pop_back();
    } else if (used_++ == chunks_.size() * kChunk) {
      chunks_.push_back(std::make_unique_for_overwrite<Window[]>(kChunk));
    }
    (*this)[id] = window;
    return id;
  }

  void Free(uint32_t id) {
    free_.push_back(id);
    --live_;
  }

  // Forgets all windows, and gives their numbers as if it were new.
  void Clear() {
    free_.clear();
    used_ = 0;
    live_ = peak_ = 0;
  }

  Window& operator[](uint32_t id) { return chunks_[id / kChunk][id % kChunk]; }
  const Window& operator[](uint32_t id) const {
    return chunks_[id / kChunk][id % kChunk];
  }

  // A window may lie across two cache lines.
  void Prefetch(uint32_t id) const {
    const auto* window = reinterpret_cast<const char*>(&(*this)[id]);
    __builtin_prefetch(window);
    __builtin_prefetch(window + sizeof(Window) - 1);
  }

  uint64_t live() const { return live_; }
  uint64_t peak() const { return peak_; }
  uint64_t bytes() const {
    return chunks_.size() * kChunk * sizeof(Window) +
           free_.capacity() * sizeof(uint32_t);
  }

 private:
  static constexpr uint32_t kChunk = 4096;

  std::vector<std::unique_ptr<Window[]>> chunks_;
  uint32_t used_ = 0;
  std::vector<uint32_t> free_;
  uint64_t live_ = 0;
  uint64_t peak_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_WINDOWS_WINDOW_POOL_H_
