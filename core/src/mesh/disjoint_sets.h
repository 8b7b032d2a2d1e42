// Sets of numbers that grow together.

#ifndef GEODESIC_MESH_DISJOINT_SETS_H_
#define GEODESIC_MESH_DISJOINT_SETS_H_

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace geodesic {

// The numbers below `size`, each in a set of its own at first. A set is named
// by its least number. (Union by halving paths.)
class DisjointSets {
 public:
  explicit DisjointSets(uint32_t size) : parent_(size), count_(size) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  uint32_t Find(uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  // Whether they were apart.
  bool Join(uint32_t a, uint32_t b) {
    a = Find(a);
    b = Find(b);
    if (a == b) return false;
    parent_[std::max(a, b)] = std::min(a, b);
    --count_;
    return true;
  }

  uint64_t count() const { return count_; }

 private:
  std::vector<uint32_t> parent_;
  uint64_t count_;
};

}  // namespace geodesic

#endif  // GEODESIC_MESH_DISJOINT_SETS_H_
