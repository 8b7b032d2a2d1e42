// Finds corners of a polygon within a triangle.

#ifndef GEODESIC_POLYGONS_CORNER_TREE_H_
#define GEODESIC_POLYGONS_CORNER_TREE_H_

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "polygons/flat_polygon.h"
#include "polygons/pace.h"

namespace geodesic {

// A kd-tree (Bentley 1975): the middle of each range lies between those that
// are before and behind it along one axis, and these are ranges of their own,
// of the other axis.
class CornerTree {
 public:
  CornerTree(const FlatPolygon& polygon, Pace& pace)
      : polygon_(polygon), pace_(pace) {}

  // Takes these corners in place of what it held. Whether to go on.
  bool Build(std::vector<uint32_t> corners) {
    corners_ = std::move(corners);
    box_ = {};
    for (const uint32_t corner : corners_) {
      box_.Add(polygon_.At(corner));
      if (!pace_.Goes()) return false;
    }
    return Sort(0, size(), 0);
  }

  uint32_t size() const { return static_cast<uint32_t>(corners_.size()); }
  // What it held, for another Build.
  std::vector<uint32_t> Take() { return std::move(corners_); }

  // Whether `is_sought` holds for any corner in the triangle, which turns left,
  // or near it. It is asked of no others but some neighbours.
  template <typename IsSought>
  bool Any(const std::array<Flat, 3>& triangle, IsSought is_sought) const {
    Sought sought{.triangle = triangle};
    for (const Flat& corner : triangle) sought.box.Add(corner);
    return AnyOf(0, size(), 0, box_, sought, is_sought);
  }

 private:
  static constexpr uint32_t kFew = 8;
  // Far more than what tolerances let a corner be outside a triangle.
  static constexpr double kMargin = 100 * kStraightCorner;

  struct Box {
    Flat low = {1e9, 1e9};
    Flat high = {-1e9, -1e9};

    void Add(const Flat& at) {
      low = {std::min(low.x, at.x), std::min(low.y, at.y)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
  };

  struct Sought {
    std::array<Flat, 3> triangle;
    Box box = {};
  };

  double Along(uint32_t corner, int axis) const {
    const Flat at = polygon_.At(corner);
    return axis == 0 ? at.x : at.y;
  }

  bool Sort(uint32_t begin, uint32_t end, int axis) {
    if (end - begin <= kFew) return true;
    const uint32_t middle = begin + (end - begin) / 2;
    return Select(begin, end, middle, axis) && Sort(begin, middle, 1 - axis) &&
           Sort(middle + 1, end, 1 - axis);
  }

  // Hoare's selection, which std::nth_element is too, but cannot be stopped.
  bool Select(uint32_t begin, uint32_t end, uint32_t middle, int axis) {
    while (end - begin > 1) {
      const double pivot = Along(corners_[begin + (end - begin) / 2], axis);
      uint32_t low = begin;
      uint32_t high = end - 1;
      while (true) {
        while (Along(corners_[low], axis) < pivot) {
          ++low;
          if (!pace_.Goes()) return false;
        }
        while (pivot < Along(corners_[high], axis)) {
          --high;
          if (!pace_.Goes()) return false;
        }
        if (low >= high) break;
        std::swap(corners_[low++], corners_[high--]);
      }
      // Now those before `low` are no greater than the pivot, the rest no less.
      if (middle < low) {
        end = low;
      } else {
        begin = low;
      }
    }
    return true;
  }

  // Whether a line parallel to a side of the box or the triangle is between
  // them.
  static bool AreApart(const Box& box, const Sought& sought) {
    if (box.high.x < sought.box.low.x - kMargin ||
        box.low.x > sought.box.high.x + kMargin ||
        box.high.y < sought.box.low.y - kMargin ||
        box.low.y > sought.box.high.y + kMargin) {
      return true;
    }
    for (int i = 0; i < 3; ++i) {
      const Flat side = sought.triangle[(i + 1) % 3] - sought.triangle[i];
      // The corner that is farthest to the left of the side.
      const Flat farthest = {side.y > 0 ? box.low.x : box.high.x,
                             side.x > 0 ? box.high.y : box.low.y};
      const Flat way = farthest - sought.triangle[i];
      if (side.x * way.y - side.y * way.x < -kMargin) return true;
    }
    return false;
  }

  template <typename IsSought>
  bool AnyOf(uint32_t begin, uint32_t end, int axis, const Box& box,
             const Sought& sought, IsSought& is_sought) const {
    if (AreApart(box, sought)) return false;
    if (end - begin <= kFew) {
      return std::any_of(corners_.begin() + begin, corners_.begin() + end,
                         is_sought);
    }
    const uint32_t middle = begin + (end - begin) / 2;
    if (is_sought(corners_[middle])) return true;
    const double split = Along(corners_[middle], axis);
    Box before = box;
    Box behind = box;
    (axis == 0 ? before.high.x : before.high.y) = split;
    (axis == 0 ? behind.low.x : behind.low.y) = split;
    return AnyOf(begin, middle, 1 - axis, before, sought, is_sought) ||
           AnyOf(middle + 1, end, 1 - axis, behind, sought, is_sought);
  }

  const FlatPolygon& polygon_;
  Pace& pace_;
  std::vector<uint32_t> corners_;
  Box box_;
};

}  // namespace geodesic

#endif  // GEODESIC_POLYGONS_CORNER_TREE_H_
