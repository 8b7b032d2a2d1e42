// The windows of each half-edge, sorted along it.

#ifndef GEODESIC_WINDOWS_WINDOW_LISTS_H_
#define GEODESIC_WINDOWS_WINDOW_LISTS_H_

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geodesic/mesh.h"

namespace geodesic {

// One short contiguous list a half-edge, all in one arena: finding the
// neighbours of a new window touches one or two cache lines, not the windows.
// Room grows by doubling; blocks that were outgrown are reused.
class WindowLists {
 public:
  struct Entry {
    double begin;  // where the window's interval begins
    uint32_t id;
  };

  explicit WindowLists(uint32_t half_edges) : heads_(half_edges) {}

  std::span<const Entry> Of(HalfEdge h) const {
    return {arena_.data() + heads_[h].offset, heads_[h].size};
  }

  // Puts `entries` in the place of entries [first, last) of h's list.
  // Invalidates spans. O(size of the list).
  void Replace(HalfEdge h, uint32_t first, uint32_t last,
               std::span<const Entry> entries);

  void PrefetchHead(HalfEdge h) const { __builtin_prefetch(&heads_[h]); }
  void PrefetchList(HalfEdge h) const {
    __builtin_prefetch(arena_.data() + heads_[h].offset);
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

  void Grow(Head& head, uint32_t size);

  std::vector<Head> heads_;
  std::vector<Entry> arena_;
  std::array<std::vector<uint32_t>, kClasses> free_;  // offsets by class
};

}  // namespace geodesic

#endif  // GEODESIC_WINDOWS_WINDOW_LISTS_H_
