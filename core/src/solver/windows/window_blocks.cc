#include "solver/windows/window_blocks.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <new>
#include <utility>

namespace geodesic {
namespace {

// Four windows of a block, as columns.
struct Tile {
  static constexpr size_t kWindows = WindowColumns::kPadding;
  double begin[kWindows], end[kWindows], x[kWindows], depth[kWindows],
      sigma[kWindows];
  uint32_t pseudo_source[kWindows];
};
static_assert(sizeof(Tile) == 22 * sizeof(double));

template <typename T>
void CopyFour(const T* from, T* to) {
  std::memcpy(to, from, Tile::kWindows * sizeof(T));
}

}  // namespace

double* BlockPool::Allocate(size_t words) {
  const std::lock_guard lock(mutex_);
  bytes_ += words * sizeof(double);
  chunks_.push_back(std::make_unique_for_overwrite<double[]>(words));
  return chunks_.back().get();
}

void BlockPool::Give(uint32_t log_room, const Magazine& magazine) {
  const std::lock_guard lock(mutex_);
  free_[log_room].push_back(magazine);
}

Magazine BlockPool::Take(uint32_t log_room) {
  const std::lock_guard lock(mutex_);
  if (free_[log_room].empty()) return {};
  const Magazine magazine = free_[log_room].back();
  free_[log_room].pop_back();
  return magazine;
}

uint64_t BlockPool::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

WindowBlock* WindowBlocks::Store(const WindowColumns& windows) {
  const size_t count = windows.size;
  const auto log_room =
      std::max(kLogLeastRoom, static_cast<uint32_t>(std::bit_width(count - 1)));
  WindowBlock* const block = New(log_room);
  block->next = nullptr;
  block->count = static_cast<uint32_t>(count);
  auto* tile = reinterpret_cast<Tile*>(WindowsOf(block));
  for (size_t i = 0; i < count; i += Tile::kWindows, ++tile) {
    CopyFour(windows.begin + i, tile->begin);
    CopyFour(windows.end + i, tile->end);
    CopyFour(windows.x + i, tile->x);
    CopyFour(windows.depth + i, tile->depth);
    CopyFour(windows.sigma + i, tile->sigma);
    CopyFour(windows.pseudo_source + i, tile->pseudo_source);
  }
  return block;
}

void WindowBlocks::Copy(const WindowBlock* block, WindowColumns& windows) {
  const size_t count = block->count, at = windows.size;
  windows.Reserve(at + count);
  const auto* tile = reinterpret_cast<const Tile*>(WindowsOf(block));
  for (size_t i = at; i < at + count; i += Tile::kWindows, ++tile) {
    CopyFour(tile->begin, windows.begin + i);
    CopyFour(tile->end, windows.end + i);
    CopyFour(tile->x, windows.x + i);
    CopyFour(tile->depth, windows.depth + i);
    CopyFour(tile->sigma, windows.sigma + i);
    CopyFour(tile->pseudo_source, windows.pseudo_source + i);
  }
  windows.size += count;
}

WindowBlock* WindowBlocks::Take(WindowBlock* block, WindowColumns& windows) {
  Copy(block, windows);
  WindowBlock* const next = block->next;
  Release(block);
  return next;
}

void WindowBlocks::Drop(WindowBlock* block) {
  while (block != nullptr) {
    WindowBlock* const next = block->next;
    Release(block);
    block = next;
  }
}

void WindowBlocks::PrefetchRest(const WindowBlock* block) {
  constexpr size_t kMost = 12;
  PrefetchLines(block, 3, std::min(kMost, (WordsOf(block->log_room) + 7) / 8));
}

WindowBlock* WindowBlocks::New(uint32_t log_room) {
  Free& free = free_[log_room];
  if (free.open.size == 0) {
    std::swap(free.open, free.full);
    if (free.open.size == 0) free.open = pool_.Take(log_room);
  }
  if (free.open.size > 0) {
    --free.open.size;
    return std::exchange(free.open.first, free.open.first->next);
  }
  const size_t words = WordsOf(log_room);
  if (words > kChunkWords / 4) {
    return new (pool_.Allocate(words)) WindowBlock{nullptr, 0, log_room};
  }
  if (words > words_left_) {
    next_ = pool_.Allocate(kChunkWords);
    words_left_ = kChunkWords;
  }
  words_left_ -= words;
  return new (std::exchange(next_, next_ + words))
      WindowBlock{nullptr, 0, log_room};
}

void WindowBlocks::Release(WindowBlock* block) {
  const uint32_t log_room = block->log_room;
  Free& free = free_[log_room];
  if (free.open.size == MagazineSize(log_room)) {
    if (free.full.size > 0) pool_.Give(log_room, free.full);
    free.full = std::exchange(free.open, {});
  }
  block->next = std::exchange(free.open.first, block);
  ++free.open.size;
}

}  // namespace geodesic
