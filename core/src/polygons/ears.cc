// Ear clipping (Meisters 1975). An ear is a corner whose triangle with its
// neighbours holds nothing of the rest of the polygon. It is cut off, the ear
// with the shortest cut first, and the rest is a polygon with one corner less.
//
// Invariant: what is left covers once what the cut triangles do not. For an ear
// with an area has no side of the polygon in it, so all of it was covered.

#include "polygons/ears.h"

#include <array>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "absl/container/btree_set.h"
#include "polygons/corner_tree.h"

namespace geodesic {
namespace {

// Of a corner in the polygon that is left, or, once it is cut, in its triangle.
struct Neighbours {
  uint32_t previous;
  uint32_t next;
};

// The order in which ears are cut: by the length of the cut; ties by vertices,
// which stay the same whatever corner the polygon begins with.
struct ShortestFirst {
  bool operator()(uint32_t a, uint32_t b) const {
    const auto [a_previous, a_next] = (*neighbours)[a];
    const auto [b_previous, b_next] = (*neighbours)[b];
    const double a_cut = polygon->SquaredDistance(a_previous, a_next);
    const double b_cut = polygon->SquaredDistance(b_previous, b_next);
    if (a_cut != b_cut) return a_cut < b_cut;
    const auto key = [this](uint32_t corner, uint32_t previous, uint32_t next) {
      return std::tuple(polygon->vertex(corner), polygon->vertex(previous),
                        polygon->vertex(next), corner);
    };
    return key(a, a_previous, a_next) < key(b, b_previous, b_next);
  }

  const FlatPolygon* polygon;
  const std::vector<Neighbours>* neighbours;
};

class EarCutter {
 public:
  EarCutter(const FlatPolygon& polygon, Pace& pace)
      : polygon_(polygon),
        pace_(pace),
        left_(polygon.size()),
        neighbours_(polygon.size()),
        is_cut_(polygon.size()),
        tree_(polygon, pace),
        ears_(ShortestFirst{&polygon, &neighbours_}),
        flat_ears_(ShortestFirst{&polygon, &neighbours_}) {}

  // Cuts all but two corners.
  bool Run() {
    std::vector<uint32_t> corners(left_);
    std::iota(corners.begin(), corners.end(), 0);
    for (const uint32_t corner : corners) {
      neighbours_[corner] = {polygon_.Previous(corner), polygon_.Next(corner)};
    }
    if (!tree_.Build(std::move(corners))) return false;
    while (left_ > 2) {
      // What was no ear may have become one where the polygon touches itself.
      const uint32_t before = left_;
      if (!Collect() || !CutCollected() || left_ == before) return false;
    }
    return true;
  }

  void Write(std::span<Triangle> triangles) const {
    auto triangle = triangles.begin();
    for (uint32_t corner = 0; corner < polygon_.size(); ++corner) {
      if (!is_cut_[corner]) continue;
      const auto [previous, next] = neighbours_[corner];
      *triangle++ = {polygon_.vertex(previous), polygon_.vertex(corner),
                     polygon_.vertex(next)};
    }
  }

 private:
  // Finds all corners that may be ears, by their angle.
  bool Collect() {
    for (uint32_t corner = 0; corner < polygon_.size(); ++corner) {
      if (!is_cut_[corner]) Add(corner);
      if (!pace_.Goes()) return false;
    }
    return true;
  }

  double TurnAt(uint32_t corner) const {
    const auto [previous, next] = neighbours_[corner];
    const Flat at = polygon_.At(corner);
    return Turn(at - polygon_.At(previous), polygon_.At(next) - at);
  }

  void Add(uint32_t corner) {
    const double turn = TurnAt(corner);
    if (turn >= 0) (turn > 0 ? ears_ : flat_ears_).insert(corner);
  }
  void Remove(uint32_t corner) {
    const double turn = TurnAt(corner);
    if (turn >= 0) (turn > 0 ? ears_ : flat_ears_).erase(corner);
  }

  // Those without an area last: others may take their corners up.
  bool CutCollected() {
    while (left_ > 2 && !(ears_.empty() && flat_ears_.empty())) {
      if (!pace_.Goes()) return false;
      const bool is_flat = ears_.empty();
      auto& ears = is_flat ? flat_ears_ : ears_;
      const uint32_t corner = *ears.begin();
      ears.erase(ears.begin());
      if (!is_flat && IsBlocked(corner)) continue;
      if (!Cut(corner)) return false;
    }
    return true;
  }

  bool Cut(uint32_t corner) {
    const auto [previous, next] = neighbours_[corner];
    Remove(previous);
    Remove(next);
    neighbours_[previous].next = next;
    neighbours_[next].previous = previous;
    is_cut_[corner] = true;
    --left_;
    if (left_ == 2) return true;
    Add(previous);
    Add(next);
    if (left_ >= tree_.size() / 2) return true;
    std::vector<uint32_t> corners = tree_.Take();
    std::erase_if(corners, [this](uint32_t c) { return is_cut_[c]; });
    return tree_.Build(std::move(corners));
  }

  // Whether a side of the polygon is inside the triangle of this corner. There
  // it has an end in the triangle, since it crosses no other side.
  bool IsBlocked(uint32_t tip) const {
    const uint32_t previous = neighbours_[tip].previous;
    const uint32_t next = neighbours_[tip].next;
    const std::array<Flat, 3> triangle = {polygon_.At(previous),
                                          polygon_.At(tip), polygon_.At(next)};
    return tree_.Any(triangle, [&](uint32_t corner) {
      if (!pace_.Goes()) return true;
      if (is_cut_[corner] || corner == previous || corner == tip ||
          corner == next) {
        return false;
      }
      return Enters(corner, triangle);
    });
  }

  // Whether a corner, or a side that begins or ends there, is inside.
  bool Enters(uint32_t corner, const std::array<Flat, 3>& triangle) const {
    const Flat at = polygon_.At(corner);
    bool previous_enters = true;
    bool next_enters = true;
    for (int i = 0; i < 3; ++i) {
      const Flat side = triangle[(i + 1) % 3] - triangle[i];
      const double turn = Turn(side, at - triangle[i]);
      if (turn < 0) return false;
      if (turn > 0) continue;
      // It lies on the side.
      const auto [previous, next] = neighbours_[corner];
      previous_enters &= Turn(side, polygon_.At(previous) - at) > 0;
      next_enters &= Turn(side, polygon_.At(next) - at) > 0;
    }
    return previous_enters || next_enters;
  }

  const FlatPolygon& polygon_;
  Pace& pace_;
  uint32_t left_;
  std::vector<Neighbours> neighbours_;
  std::vector<bool> is_cut_;
  CornerTree tree_;
  // Corners that may be ears; those whose triangles have no area are.
  absl::btree_set<uint32_t, ShortestFirst> ears_;
  absl::btree_set<uint32_t, ShortestFirst> flat_ears_;
};

}  // namespace

bool CutEars(const FlatPolygon& polygon, Pace& pace,
             std::span<Triangle> triangles) {
  EarCutter cutter(polygon, pace);
  if (!cutter.Run()) return false;
  cutter.Write(triangles);
  return true;
}

}  // namespace geodesic
