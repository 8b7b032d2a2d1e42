// Windows that go round and round where faces have hardly any angle around a
// vertex, or along a tube of needles. Each turn loses to the one before by too
// little for a filter to see, or by less than a rounding, and then without end.

#ifndef GEODESIC_SOLVER_RULES_WINDING_H_
#define GEODESIC_SOLVER_RULES_WINDING_H_

#include "geodesic/mesh.h"
#include "solver/windows/window.h"

namespace geodesic {

// Whether the straight line of a window on h came through h before, on its way
// from the pseudo-source. Such a window is of no use: a shortest path enters a
// face once at most (Chen, Han: Shortest paths on a polyhedron. SoCG 1990).
// Follows the line back through kMostTurned faces at the most.
// REQUIRES: the window is not merged; its pseudo-source lies on its line.
bool ComesBack(const Mesh& mesh, HalfEdge h, const Window& window);

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_WINDING_H_
