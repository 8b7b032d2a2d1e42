// Where lists of windows wait until their half-edge is due.

#ifndef GEODESIC_WINDOWS_WINDOW_BLOCKS_H_
#define GEODESIC_WINDOWS_WINDOW_BLOCKS_H_

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "windows/window_columns.h"

namespace geodesic {

// A list in the arena. Its distances are not kept.
struct WindowBlock {
  uint32_t place = 0;  // in steps of kStep bytes
  uint32_t count = 0;  // 0: no list, no room
};

// Blocks of columns in one arena, by powers of two; freed ones are reused.
class WindowBlocks {
 public:
  // Copies windows to a block of their own.
  WindowBlock Store(const WindowColumns& windows);
  // Appends the windows of a block to `windows`, without their distances, and
  // frees the block. REQUIRES: `windows` has room for them.
  void Take(WindowBlock block, WindowColumns& windows);

  void Prefetch(const WindowBlock& block) const {
    const double* at = arena_.data() + size_t{block.place} * kLeastWords;
    const size_t lines = (size_t{block.count} * 11 / 2 + 7) / 8;
    for (size_t i = 0; i < lines && i < 12; ++i) {
      __builtin_prefetch(at + 8 * i);
    }
  }

  uint64_t bytes() const {
    uint64_t bytes = arena_.capacity() * sizeof(double);
    for (const std::vector<uint32_t>& places : free_) {
      bytes += places.capacity() * sizeof(uint32_t);
    }
    return bytes;
  }

 private:
  static constexpr uint32_t kLeastRoom = 4;
  static constexpr size_t kLeastWords = 22;  // five doubles and a half, times 4

  static uint32_t RoomFor(uint32_t count) {
    return count <= kLeastRoom ? kLeastRoom : std::bit_ceil(count);
  }
  std::vector<uint32_t>& FreeOf(uint32_t room) {
    return free_[std::countr_zero(room)];
  }

  std::vector<double> arena_;
  std::array<std::vector<uint32_t>, 32> free_;  // places by log2 of room
};

}  // namespace geodesic

#endif  // GEODESIC_WINDOWS_WINDOW_BLOCKS_H_
