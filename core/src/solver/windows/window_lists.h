// The windows of each half-edge, sorted along it.

#ifndef GEODESIC_SOLVER_WINDOWS_WINDOW_LISTS_H_
#define GEODESIC_SOLVER_WINDOWS_WINDOW_LISTS_H_

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "geodesic/mesh.h"
#include "solver/windows/window.h"

namespace geodesic {

// A window in the list of its half-edge: one cache line.
template <typename OriginType>
struct alignas(64) BasicListedWindow {
  BasicWindow<OriginType> window;
  uint32_t pseudo_source;
};
using ListedWindow = BasicListedWindow<Origin>;
static_assert(sizeof(ListedWindow) == 64);

// In the place of a window's label once it has been propagated.
inline constexpr double kPropagated = std::numeric_limits<double>::infinity();

// One contiguous gap buffer a half-edge. The gap is the list's cursor: windows
// are added before it and looked at after it, and it stays where it was left.
// Neighbouring windows tend to arrive one after the other, so few move for
// each.
//
// Pointers stay valid until the next Add. Room grows by doubling; blocks that
// were outgrown are reused. Blocks are cut from chunks, which never move, so
// that no more memory is taken than bytes() tells.
template <typename OriginType>
class WindowLists {
 public:
  using ListedWindow = BasicListedWindow<OriginType>;

  explicit WindowLists(uint32_t half_edges) : slots_(half_edges, kNoList) {}

  // Whether h has got anything since it was last dropped.
  bool has_room(HalfEdge h) const { return slots_[h] != kNoList; }

  // The label that the half-edge waits with in a queue; kPropagated if it does
  // not, or has no list.
  double queued(HalfEdge h) const { return HeadOf(h).queued; }
  // REQUIRES: has_room(h).
  void set_queued(HalfEdge h, double label) { HeadOf(h).queued = label; }

  // Moves the cursor to behind all windows that end at `at` or before.
  // O(windows passed).
  void Seek(HalfEdge h, double at) {
    Head& list = HeadOf(h);
    while (list.before > 0 &&
           Begin(list)[list.before - 1].window.interval.end > at) {
      --list.before;
      ++list.after;
      *Next(list) = Begin(list)[list.before];
      *NextLabel(list) = Labels(list)[list.before];
    }
    while (list.after > 0 && Next(list)->window.interval.end <= at) Pass(h);
  }

  // Windows of h, propagated or not.
  size_t size(HalfEdge h) const { return HeadOf(h).before + HeadOf(h).after; }

  // The window after the cursor; nullptr at the end of the list.
  ListedWindow* Next(HalfEdge h) {
    return HeadOf(h).after == 0 ? nullptr : Next(HeadOf(h));
  }
  // REQUIRES: Next(h) is not null.
  double NextLabel(HalfEdge h) { return *NextLabel(HeadOf(h)); }
  // Moves the cursor over the next window.
  void Pass(HalfEdge h) {
    Head& list = HeadOf(h);
    Begin(list)[list.before] = *Next(list);
    Labels(list)[list.before] = *NextLabel(list);
    ++list.before;
    --list.after;
  }
  void RemoveNext(HalfEdge h) {
    --HeadOf(h).after;
    --size_;
  }
  // Windows before the cursor, and the i-th of them back from it.
  uint32_t before(HalfEdge h) const { return HeadOf(h).before; }
  // REQUIRES: i < before(h).
  ListedWindow& Previous(HalfEdge h, uint32_t i) {
    const Head& list = HeadOf(h);
    return Begin(list)[list.before - 1 - i];
  }
  double& PreviousLabel(HalfEdge h, uint32_t i) {
    const Head& list = HeadOf(h);
    return Labels(list)[list.before - 1 - i];
  }
  // REQUIRES: before(h) > 0.
  void RemovePrevious(HalfEdge h) {
    --HeadOf(h).before;
    --size_;
  }
  // Makes room for `count` windows more.
  void MakeRoom(HalfEdge h, uint32_t count) {
    const auto needed = static_cast<uint32_t>(size(h) + count);
    if (needed > HeadOf(h).room) Grow(h, needed);
  }
  // Adds a window before the cursor.
  void Add(HalfEdge h, const ListedWindow& window, double label) {
    MakeRoom(h, 1);
    Head& list = HeadOf(h);
    Begin(list)[list.before] = window;
    Labels(list)[list.before] = label;
    ++list.before;
    peak_size_ = std::max(peak_size_, ++size_);
  }

  // Calls take(window) for the first windows of h with labels up to `due`,
  // `most` at the most, and marks them as propagated. `take` changes no list.
  template <typename Take>
  void TakeDue(HalfEdge h, double due, size_t most, Take take) {
    const Head& list = HeadOf(h);
    const auto take_from = [&](const ListedWindow* windows, double* labels,
                               uint32_t count) {
      for (uint32_t i = 0; i < count && most > 0; ++i) {
        if (labels[i] > due) continue;
        labels[i] = kPropagated;
        --most;
        take(windows[i]);
      }
    };
    take_from(Begin(list), Labels(list), list.before);
    take_from(Next(list), NextLabel(list), list.after);
  }

  // Windows of h that are not propagated yet.
  uint32_t Pending(HalfEdge h) const;

  // Empties h's list and gives its room back.
  void Drop(HalfEdge h);

  // Windows in all lists, now and at the most.
  uint64_t size() const { return size_; }
  uint64_t peak_size() const { return peak_size_; }

  // Fetches into cache where a list lies, then (once that has arrived) its
  // beginning, or what surrounds its cursor.
  void PrefetchHead(HalfEdge h) const { __builtin_prefetch(&slots_[h]); }
  void PrefetchList(HalfEdge h) const {
    const Head& list = HeadOf(h);
    __builtin_prefetch(list.block.labels);
    for (uint32_t i = 0; i < std::min(list.room, kPrefetched); ++i) {
      __builtin_prefetch(list.block.windows + i);
    }
  }
  void PrefetchCursor(HalfEdge h) const {
    const Head& list = HeadOf(h);
    const uint32_t next = list.room - list.after;
    for (uint32_t i : {list.before - 1, list.before, next, next + 1}) {
      if (i < list.room) __builtin_prefetch(list.block.windows + i);
    }
    __builtin_prefetch(list.block.labels + list.before);
    __builtin_prefetch(list.block.labels + next);
  }

  uint64_t bytes() const;

 private:
  struct Block {
    ListedWindow* windows = nullptr;
    double* labels = nullptr;
  };
  // Windows [0, before) and [room - after, room) of a block; the rest is gap.
  struct Head {
    Block block;
    uint32_t room = 0;  // a power of two, or no block at all
    uint32_t before = 0;
    uint32_t after = 0;
    double queued = kPropagated;
  };
  // The head of a half-edge without a list: empty.
  static constexpr uint32_t kNoList = 0;
  static constexpr uint32_t kLeastRoom = 2;
  static constexpr uint32_t kClasses = 32;
  static constexpr uint32_t kPrefetched = 8;
  // Windows of a chunk: a quarter of what is there, within these.
  static constexpr uint64_t kLeastChunk = 64;
  static constexpr uint64_t kMostChunk = 1 << 16;

  static double* Labels(const Head& list) { return list.block.labels; }
  static double* NextLabel(const Head& list) {
    return list.block.labels + (list.room - list.after);
  }
  static ListedWindow* Begin(const Head& list) { return list.block.windows; }
  static ListedWindow* Next(const Head& list) {
    return list.block.windows + (list.room - list.after);
  }
  std::vector<Block>& FreeOf(uint32_t room) {
    return free_[std::countr_zero(room)];
  }
  // The next `room` windows of the last chunk. REQUIRES: it has them.
  Block Cut(uint32_t room);
  // One that has room for so many; what the last one has left becomes free.
  void AddChunk(uint32_t room);
  Head& HeadOf(HalfEdge h) { return heads_[slots_[h]]; }
  const Head& HeadOf(HalfEdge h) const { return heads_[slots_[h]]; }
  // To a room of `needed` at the least.
  void Grow(HalfEdge h, uint32_t needed);

  // Of each half-edge its head. Few have a list at a time: their heads lie
  // together, in cache, and the others take four bytes.
  std::vector<uint32_t> slots_;
  std::vector<Head> heads_{1};
  std::vector<uint32_t> free_heads_;
  std::vector<std::unique_ptr<ListedWindow[]>> windows_;  // by chunk
  std::vector<std::unique_ptr<double[]>> labels_;         // of them
  uint64_t chunk_windows_ = 0;                            // of all chunks
  Block rest_;                                            // of the last chunk
  uint64_t rest_room_ = 0;
  std::array<std::vector<Block>, kClasses> free_;  // by log2 of room
  uint64_t size_ = 0;
  uint64_t peak_size_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_WINDOWS_WINDOW_LISTS_H_
