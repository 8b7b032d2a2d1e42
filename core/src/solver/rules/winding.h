// Windows that go round and round where faces have hardly any angle around a
// vertex, or along a tube of needles. Each turn loses to the one before by too
// little for a filter to see, or by less than a rounding, and then without end.

#ifndef GEODESIC_SOLVER_RULES_WINDING_H_
#define GEODESIC_SOLVER_RULES_WINDING_H_

#include <cstdint>

#include "geodesic/mesh.h"
#include "solver/windows/window.h"

namespace geodesic {

// Whether the straight line of a window on h came through h before, on its way
// from the pseudo-source. Such a window is of no use: a shortest path enters a
// face once at most (Chen, Han: Shortest paths on a polyhedron. SoCG 1990).
// Follows the line back through kMostTurned faces at the most, and adds how
// many these were to `followed`.
// REQUIRES: the window is not merged; its pseudo-source lies on its line.
bool ComesBack(const Mesh& mesh, HalfEdge h, const Window& window,
               uint64_t& followed);

// What is known of windows at a half-edge.
enum class Winding {
  kUnknown,
  kSuspected,  // some may come back
  kCertain,    // all do
};

// When to look whether windows come back. What winds comes to the same places
// again and again, so it need not be looked at every time; and around a vertex
// of a thousand faces, where wavefronts cross half-edges as often, lines are
// long. Looking takes less time than propagating: a face about 3 ns, a window
// 40 or more.
class WindingWatch {
 public:
  bool MayLook() const { return followed_ <= kFacesAWindow * propagated_; }
  void Count(uint64_t propagated, uint64_t followed) {
    propagated_ += propagated;
    followed_ += followed;
  }
  void Clear() { propagated_ = followed_ = 0; }

 private:
  static constexpr uint64_t kFacesAWindow = 2;

  uint64_t propagated_ = 0, followed_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_WINDING_H_
