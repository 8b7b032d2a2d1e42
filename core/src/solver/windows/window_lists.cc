#include "solver/windows/window_lists.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "solver/windows/mixed_origin.h"

namespace geodesic {

template <typename OriginType>
uint32_t WindowLists<OriginType>::Pending(HalfEdge h) const {
  const Head& list = HeadOf(h);
  const double* labels = Labels(list);
  const double* next = NextLabel(list);
  return static_cast<uint32_t>(
      list.before + list.after -
      std::count(labels, labels + list.before, kPropagated) -
      std::count(next, next + list.after, kPropagated));
}

template <typename OriginType>
void WindowLists<OriginType>::Drop(HalfEdge h) {
  if (!has_room(h)) return;
  Head& list = HeadOf(h);
  FreeOf(list.room).push_back(list.block);
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
  if (std::vector<Block>& free = FreeOf(grown.room); free.empty()) {
    if (rest_room_ < grown.room) AddChunk(grown.room);
    grown.block = Cut(grown.room);
  } else {
    grown.block = free.back();
    free.pop_back();
  }
  std::copy_n(Begin(list), list.before, Begin(grown));
  std::copy_n(Next(list), list.after, Next(grown));
  std::copy_n(Labels(list), list.before, Labels(grown));
  std::copy_n(NextLabel(list), list.after, NextLabel(grown));
  if (list.room != 0) FreeOf(list.room).push_back(list.block);
  list = grown;
}

template <typename OriginType>
typename WindowLists<OriginType>::Block WindowLists<OriginType>::Cut(
    uint32_t room) {
  const Block block = rest_;
  rest_room_ -= room;
  rest_ = {block.windows + room, block.labels + room};
  return block;
}

template <typename OriginType>
void WindowLists<OriginType>::AddChunk(uint32_t room) {
  while (rest_room_ >= kLeastRoom) {
    const auto part = static_cast<uint32_t>(std::bit_floor(rest_room_));
    FreeOf(part).push_back(Cut(part));
  }
  rest_room_ = std::max<uint64_t>(
      room, std::clamp(chunk_windows_ / 4, kLeastChunk, kMostChunk));
  chunk_windows_ += rest_room_;
  windows_.push_back(
      std::make_unique_for_overwrite<ListedWindow[]>(rest_room_));
  labels_.push_back(std::make_unique_for_overwrite<double[]>(rest_room_));
  rest_ = {windows_.back().get(), labels_.back().get()};
}

template <typename OriginType>
uint64_t WindowLists<OriginType>::bytes() const {
  uint64_t bytes = slots_.capacity() * sizeof(uint32_t) +
                   heads_.capacity() * sizeof(Head) +
                   free_heads_.capacity() * sizeof(uint32_t) +
                   chunk_windows_ * (sizeof(ListedWindow) + sizeof(double));
  for (const std::vector<Block>& blocks : free_) {
    bytes += blocks.capacity() * sizeof(Block);
  }
  return bytes;
}

template class WindowLists<Origin>;
template class WindowLists<MixedOrigin>;

}  // namespace geodesic
