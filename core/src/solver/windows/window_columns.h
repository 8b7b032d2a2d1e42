// Windows of one half-edge as a structure of arrays: what is done with a whole
// list at once runs over columns.

#ifndef GEODESIC_SOLVER_WINDOWS_WINDOW_COLUMNS_H_
#define GEODESIC_SOLVER_WINDOWS_WINDOW_COLUMNS_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "solver/windows/window.h"

namespace geodesic {

// The columns of `size` windows, with room for more. Scratch: it grows, and
// keeps its memory.
class WindowColumns {
 public:
  // Columns may be written this far beyond `size`, less one.
  static constexpr size_t kPadding = 4;

  double* begin = nullptr;
  double* end = nullptr;
  double* x = nullptr;
  double* depth = nullptr;
  double* sigma = nullptr;
  double* begin_distance = nullptr;
  double* end_distance = nullptr;
  uint32_t* pseudo_source = nullptr;
  size_t size = 0;

  WindowColumns() = default;
  WindowColumns(const WindowColumns&) = delete;
  WindowColumns& operator=(const WindowColumns&) = delete;

  // Makes room for `count` windows.
  void Reserve(size_t count) {
    if (count + kPadding > room_) Grow(count + kPadding);
  }

  Interval IntervalAt(size_t i) const { return {begin[i], end[i]}; }
  Origin OriginAt(size_t i) const { return {x[i], depth[i], sigma[i]}; }
  Window At(size_t i) const {
    return {IntervalAt(i), OriginAt(i), begin_distance[i], end_distance[i]};
  }
  void Set(size_t i, const Window& window) {
    begin[i] = window.interval.begin;
    end[i] = window.interval.end;
    x[i] = window.origin.x;
    depth[i] = window.origin.depth;
    sigma[i] = window.origin.sigma;
    begin_distance[i] = window.begin_distance;
    end_distance[i] = window.end_distance;
  }
  void Set(size_t i, const Window& window, uint32_t source) {
    Set(i, window);
    pseudo_source[i] = source;
  }
  void Move(size_t from, size_t to) {
    begin[to] = begin[from];
    end[to] = end[from];
    x[to] = x[from];
    depth[to] = depth[from];
    sigma[to] = sigma[from];
    begin_distance[to] = begin_distance[from];
    end_distance[to] = end_distance[from];
    pseudo_source[to] = pseudo_source[from];
  }

  // Appends those of `other`. Their distances at the ends come along.
  void Append(const WindowColumns& other) {
    Reserve(size + other.size);
    for (size_t i = 0; i < other.size; ++i) {
      Set(size++, other.At(i), other.pseudo_source[i]);
    }
  }

  // Drops those from `first` on for which not keeps(i).
  template <typename Keeps>
  void KeepIf(size_t first, Keeps keeps) {
    size_t kept = first;
    for (size_t i = first; i < size; ++i) {
      if (!keeps(i)) continue;
      if (kept != i) Move(i, kept);
      ++kept;
    }
    size = kept;
  }

  // Into a frame that is turned over, on an edge of this length.
  void Mirror(double length) {
    for (size_t i = 0, j = size; i < j--; ++i) {
      const Window first = At(i), last = At(j);
      const uint32_t first_source = pseudo_source[i];
      Set(i, MirrorOf(last, length), pseudo_source[j]);
      Set(j, MirrorOf(first, length), first_source);
    }
  }

  uint64_t bytes() const {
    return room_ * (7 * sizeof(double) + sizeof(uint32_t));
  }

 private:
  static Window MirrorOf(const Window& window, double length) {
    return {geodesic::Mirror(window.interval, length),
            geodesic::Mirror(window.origin, length), window.end_distance,
            window.begin_distance};
  }
  void Grow(size_t count) {
    const size_t room = 2 * count;
    std::vector<double> values(7 * room);
    double* next = values.data();
    for (double** column :
         {&begin, &end, &x, &depth, &sigma, &begin_distance, &end_distance}) {
      std::copy_n(*column, size, next);
      *column = next;
      next += room;
    }
    values_ = std::move(values);
    sources_.resize(room);
    pseudo_source = sources_.data();
    room_ = room;
  }

  size_t room_ = 0;
  std::vector<double> values_;
  std::vector<uint32_t> sources_;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_WINDOWS_WINDOW_COLUMNS_H_
