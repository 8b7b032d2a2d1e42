// Windows by 32-bit number, recycled.

#ifndef GEODESIC_WINDOWS_WINDOW_POOL_H_
#define GEODESIC_WINDOWS_WINDOW_POOL_H_

#include <algorithm>
#include <cstdint>
#include <vector>

namespace geodesic {

// Numbers are dense and reused, most recently freed first, so that a live
// wavefront stays in cache. References are invalidated by Allocate.
template <typename Window>
class WindowPool {
 public:
  uint32_t Allocate(const Window& window) {
    peak_ = std::max(peak_, ++live_);
    if (free_.empty()) {
      windows_.push_back(window);
      return static_cast<uint32_t>(windows_.size() - 1);
    }
    const uint32_t id = free_.back();
    free_.pop_back();
    windows_[id] = window;
    return id;
  }

  void Free(uint32_t id) {
    free_.push_back(id);
    --live_;
  }

  Window& operator[](uint32_t id) { return windows_[id]; }
  const Window& operator[](uint32_t id) const { return windows_[id]; }

  void Prefetch(uint32_t id) const { __builtin_prefetch(&windows_[id]); }

  uint64_t live() const { return live_; }
  uint64_t peak() const { return peak_; }
  uint64_t bytes() const {
    return windows_.capacity() * sizeof(Window) +
           free_.capacity() * sizeof(uint32_t);
  }

 private:
  std::vector<Window> windows_;
  std::vector<uint32_t> free_;
  uint64_t live_ = 0;
  uint64_t peak_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_WINDOWS_WINDOW_POOL_H_
