#include "windows/window_blocks.h"

#include <algorithm>
#include <cstring>

namespace geodesic {
namespace {

void CopyColumn(const double* from, double* to, size_t count) {
  for (size_t i = 0; i < count; i += WindowColumns::kPadding) {
    std::memcpy(to + i, from + i, WindowColumns::kPadding * sizeof(double));
  }
}

void CopySources(const void* from, void* to, size_t count) {
  constexpr size_t kBytes = WindowColumns::kPadding * sizeof(uint32_t);
  for (size_t i = 0; i < count; i += WindowColumns::kPadding) {
    std::memcpy(static_cast<char*>(to) + i * sizeof(uint32_t),
                static_cast<const char*>(from) + i * sizeof(uint32_t), kBytes);
  }
}

}  // namespace

WindowBlock WindowBlocks::Store(const WindowColumns& windows) {
  const auto count = static_cast<uint32_t>(windows.size);
  const size_t room = RoomFor(count);
  WindowBlock block{.count = count};
  if (std::vector<uint32_t>& free = FreeOf(room); free.empty()) {
    block.place = static_cast<uint32_t>(arena_.size() / kLeastWords);
    arena_.resize(arena_.size() + room / kLeastRoom * kLeastWords);
  } else {
    block.place = free.back();
    free.pop_back();
  }
  double* to = arena_.data() + size_t{block.place} * kLeastWords;
  for (const double* from :
       {windows.begin, windows.end, windows.x, windows.depth, windows.sigma}) {
    CopyColumn(from, to, count);
    to += room;
  }
  CopySources(windows.pseudo_source, to, count);
  return block;
}

void WindowBlocks::Take(WindowBlock block, WindowColumns& windows) {
  const size_t count = block.count, at = windows.size;
  const size_t room = RoomFor(block.count);
  const double* from = arena_.data() + size_t{block.place} * kLeastWords;
  for (double* to :
       {windows.begin, windows.end, windows.x, windows.depth, windows.sigma}) {
    CopyColumn(from, to + at, count);
    from += room;
  }
  CopySources(from, windows.pseudo_source + at, count);
  windows.size += count;
  FreeOf(room).push_back(block.place);
}

}  // namespace geodesic
