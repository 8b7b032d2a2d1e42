// The windows of each half-edge, sorted along it.

#ifndef GEODESIC_WINDOWS_WINDOW_LISTS_H_
#define GEODESIC_WINDOWS_WINDOW_LISTS_H_

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geodesic/mesh.h"
#include "windows/window.h"

namespace geodesic {

// A window in the list of its half-edge: one cache line.
struct alignas(64) ListedWindow {
  Window window;
  uint32_t pseudo_source;
  uint32_t id;  // in the queue; kNothing once propagated
};
static_assert(sizeof(ListedWindow) == 64);

// One short contiguous list a half-edge, all in one arena: the neighbours of a
// new window are found and trimmed in place. Room grows by doubling; blocks
// that were outgrown are reused.
class WindowLists {
 public:
  explicit WindowLists(uint32_t half_edges) : heads_(half_edges) {}

  std::span<ListedWindow> Of(HalfEdge h) {
    return {arena_.data() + heads_[h].offset, heads_[h].size};
  }

  // Puts `windows` in the place of windows [first, last) of h's list.
  // Invalidates spans. O(size of the list).
  void Replace(HalfEdge h, uint32_t first, uint32_t last,
               std::span<const ListedWindow> windows);

  // Empties h's list and gives its room back. Invalidates spans.
  void Drop(HalfEdge h);

  // Windows in all lists, now and at the most.
  uint64_t size() const { return size_; }
  uint64_t peak_size() const { return peak_size_; }

  // Fetches into cache where a list lies, then (once that has arrived) its
  // beginning.
  void PrefetchHead(HalfEdge h) const { __builtin_prefetch(&heads_[h]); }
  void PrefetchList(HalfEdge h) const {
    const ListedWindow* list = arena_.data() + heads_[h].offset;
    for (uint32_t i = 0; i < kPrefetched; ++i) __builtin_prefetch(list + i);
  }

  uint64_t bytes() const;

 private:
  struct Head {
    uint32_t offset = 0;
    uint32_t size = 0;
    uint32_t size_class = 0;  // capacity 2^size_class; 0 is no block at all
  };
  static constexpr uint32_t kFirstClass = 2;
  static constexpr uint32_t kClasses = 32;
  static constexpr uint32_t kPrefetched = 4;

  void Grow(Head& head, uint32_t size);

  std::vector<Head> heads_;
  std::vector<ListedWindow> arena_;
  std::array<std::vector<uint32_t>, kClasses> free_;  // offsets by class
  uint64_t size_ = 0;
  uint64_t peak_size_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_WINDOWS_WINDOW_LISTS_H_
