#include "solver/windows/window_lists.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

#include "solver/windows/mixed_origin.h"

namespace geodesic {

template <typename OriginType>
uint32_t WindowLists<OriginType>::Pending(HalfEdge h) const {
  const Head& list = HeadOf(h);
  const double* labels = labels_.data() + list.offset;
  const double* next = labels + list.room - list.after;
  return static_cast<uint32_t>(
      list.before + list.after -
      std::count(labels, labels + list.before, kPropagated) -
      std::count(next, next + list.after, kPropagated));
}

template <typename OriginType>
void WindowLists<OriginType>::Drop(HalfEdge h) {
  if (!has_room(h)) return;
  Head& list = HeadOf(h);
  FreeOf(list.room).push_back(list.offset);
  size_ -= list.before + list.after;
  list = {};
  free_heads_.push_back(std::exchange(slots_[h], kNoList));
}

template <typename OriginType>
void WindowLists<OriginType>::Grow(HalfEdge h, uint32_t needed) {
  if (!has_room(h)) {
    if (free_heads_.empty()) {
      free_heads_.push_back(static_cast<uint32_t>(heads_.size()));
      heads_.emplace_back();
    }
    slots_[h] = free_heads_.back();
    free_heads_.pop_back();
  }
  Head& list = HeadOf(h);
  Head grown = list;
  grown.room = std::bit_ceil(std::max(needed, kLeastRoom));
  if (std::vector<uint32_t>& free = FreeOf(grown.room); free.empty()) {
    grown.offset = static_cast<uint32_t>(arena_.size());
    const size_t size = arena_.size() + grown.room;
    if (size > arena_.capacity()) {
      // By a quarter: to double would waste more memory than it spares copies.
      arena_.reserve(std::max(size, arena_.capacity() / 4 * 5));
      labels_.reserve(arena_.capacity());
    }
    arena_.resize(size);
    labels_.resize(size);
  } else {
    grown.offset = free.back();
    free.pop_back();
  }
  std::copy_n(Begin(list), list.before, Begin(grown));
  std::copy_n(Next(list), list.after, Next(grown));
  std::copy_n(Labels(list), list.before, Labels(grown));
  std::copy_n(NextLabel(list), list.after, NextLabel(grown));
  if (list.room != 0) FreeOf(list.room).push_back(list.offset);
  list = grown;
}

template <typename OriginType>
uint64_t WindowLists<OriginType>::bytes() const {
  uint64_t bytes = slots_.capacity() * sizeof(uint32_t) +
                   heads_.capacity() * sizeof(Head) +
                   free_heads_.capacity() * sizeof(uint32_t) +
                   arena_.capacity() * sizeof(ListedWindow) +
                   labels_.capacity() * sizeof(double);
  for (const std::vector<uint32_t>& offsets : free_) {
    bytes += offsets.capacity() * sizeof(uint32_t);
  }
  return bytes;
}

template class WindowLists<Origin>;
template class WindowLists<MixedOrigin>;

}  // namespace geodesic
