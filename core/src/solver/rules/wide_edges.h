// What goes on across edges of very many faces: into some of them at a time, so
// that a computation can be stopped in between.

#ifndef GEODESIC_SOLVER_RULES_WIDE_EDGES_H_
#define GEODESIC_SOLVER_RULES_WIDE_EDGES_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>

#include "geodesic/mesh.h"

namespace geodesic {

// Whether so many faces share the edge of h that to enter all takes long: a
// millisecond and more.
inline bool IsWideEdge(const Mesh& mesh, HalfEdge h) {
  constexpr size_t kMany = 1024;
  return mesh.HalfEdgesAt(h).size() > kMany;
}

// A rule or a sink that takes a window beyond an edge of very many faces.
template <typename Rule>
concept ToldOfWideEdges = requires {
  requires Rule::kTakesWideEdges;
};

// Item: what goes on across a side, in the frame that an oriented neighbour
// has.
template <typename Item>
class WideEdges {
 public:
  bool IsEmpty() const { return waiting_.empty(); }
  void Add(HalfEdge side, const Item& item) {
    waiting_.push_back({side, item});
  }

  // Calls enter(side, half_edge, is_mirrored, item) for the next half-edges
  // beyond the side of the first item, `most` of them or fewer, in the order of
  // Mesh::ForEachBeyond; then done(item) if these were the last.
  // REQUIRES: !IsEmpty().
  template <typename Enter, typename Done>
  void Spread(const Mesh& mesh, size_t most, Enter enter, Done done) {
    Waiting& first = waiting_.front();
    const std::span<const HalfEdge> half_edges = mesh.HalfEdgesAt(first.side);
    for (; most > 0 && first.entered < half_edges.size(); --most) {
      const HalfEdge half_edge = half_edges[first.entered++];
      if (half_edge == first.side) continue;
      enter(first.side, half_edge,
            mesh.From(half_edge) == mesh.From(first.side), first.item);
    }
    if (first.entered < half_edges.size()) return;
    done(first.item);
    waiting_.pop_front();
  }

 private:
  struct Waiting {
    HalfEdge side;
    Item item;
    size_t entered = 0;  // of the edge's half-edges
  };

  std::deque<Waiting> waiting_;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_WIDE_EDGES_H_
