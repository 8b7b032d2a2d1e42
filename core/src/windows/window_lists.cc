#include "windows/window_lists.h"

#include <algorithm>

namespace geodesic {

void WindowLists::Replace(HalfEdge h, uint32_t first, uint32_t last,
                          std::span<const ListedWindow> windows) {
  Head& head = heads_[h];
  const uint32_t old_size = head.size;
  const uint32_t size =
      old_size - (last - first) + static_cast<uint32_t>(windows.size());
  if (head.size_class == 0 || size > (1u << head.size_class)) {
    Grow(head, size);
  }
  ListedWindow* list = arena_.data() + head.offset;
  if (size < old_size) {
    std::move(list + last, list + old_size, list + first + windows.size());
  } else if (size > old_size) {
    std::move_backward(list + last, list + old_size, list + size);
  }
  std::copy(windows.begin(), windows.end(), list + first);
  head.size = size;
  size_ += windows.size();
  size_ -= last - first;
  peak_size_ = std::max(peak_size_, size_);
}

void WindowLists::Drop(HalfEdge h) {
  Head& head = heads_[h];
  if (head.size_class != 0) free_[head.size_class].push_back(head.offset);
  size_ -= head.size;
  head = {};
}

void WindowLists::Grow(Head& head, uint32_t size) {
  uint32_t size_class = std::max(head.size_class, kFirstClass);
  while ((1u << size_class) < size) ++size_class;
  uint32_t offset;
  if (free_[size_class].empty()) {
    offset = static_cast<uint32_t>(arena_.size());
    arena_.resize(arena_.size() + (size_t{1} << size_class));
  } else {
    offset = free_[size_class].back();
    free_[size_class].pop_back();
  }
  std::copy_n(arena_.begin() + head.offset, head.size, arena_.begin() + offset);
  if (head.size_class != 0) free_[head.size_class].push_back(head.offset);
  head.offset = offset;
  head.size_class = size_class;
}

uint64_t WindowLists::bytes() const {
  uint64_t bytes = heads_.capacity() * sizeof(Head) +
                   arena_.capacity() * sizeof(ListedWindow);
  for (const std::vector<uint32_t>& offsets : free_) {
    bytes += offsets.capacity() * sizeof(uint32_t);
  }
  return bytes;
}

}  // namespace geodesic
