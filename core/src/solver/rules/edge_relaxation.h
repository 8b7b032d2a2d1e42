// What windows miss where faces are hardly higher than rounding: vertices that
// are farther than the way along an edge from a neighbour, or not reached.

#ifndef GEODESIC_SOLVER_RULES_EDGE_RELAXATION_H_
#define GEODESIC_SOLVER_RULES_EDGE_RELAXATION_H_

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "solver/rules/front.h"
#include "solver/rules/shadow_fan.h"
#include "tolerances.h"

namespace geodesic {

// Relaxes `to` along an edge of that length if it is farther than that way, and
// this is no longer than `limit`. Returns whether it was.
template <typename Front>
bool RelaxAlongEdge(Front& front, uint32_t from, uint32_t to, double length,
                    double limit) {
  const double most = front.UpperBound(from) + length;
  if (!(most < front.distance(to) * (1 - kAlongEdge))) return false;
  if (!(most <= limit)) return false;
  front.Relax(to, front.distance(from) + length, {.pseudo_source = from},
              IncomingRay::Bent());
  return true;
}

// Along all edges of the mesh. Returns whether any vertex that is no farther
// than `limit` was relaxed. O(F).
template <typename Front>
bool RelaxAlongEdges(Front& front, double limit) {
  const Mesh& mesh = front.mesh();
  bool has_relaxed = false;
  for (HalfEdge first = 0; first < mesh.half_edge_count(); first += 3) {
    const Triangle& corners = mesh.TriangleOf(first);
    for (uint32_t i = 0; i < 3; ++i) {
      const uint32_t a = corners[i], b = corners[i == 2 ? 0 : i + 1];
      const double length = mesh.frame(first + i).length;
      has_relaxed |= RelaxAlongEdge(front, a, b, length, limit);
      has_relaxed |= RelaxAlongEdge(front, b, a, length, limit);
    }
  }
  return has_relaxed;
}

// The same beside vertices that were reached, within the goal's limit.
// O(these). REQUIRES: the front has a goal.
template <typename Front>
bool RelaxAlongEdgesToGoal(Front& front) {
  const Mesh& mesh = front.mesh();
  bool has_relaxed = false;
  const auto relax = [&](uint32_t from, uint32_t to, HalfEdge along) {
    const double limit = front.goal().limit() - front.goal().Bound(to);
    has_relaxed |=
        RelaxAlongEdge(front, from, to, mesh.frame(along).length, limit);
  };
  // Those that are reached on the way count, too.
  for (size_t i = 0; i < front.reached_list().size(); ++i) {
    const uint32_t v = front.reached_list()[i];
    for (const HalfEdge h : mesh.Outgoing(v)) {
      relax(v, mesh.To(h), h);
      relax(v, mesh.Apex(h), Prev(h));
    }
  }
  return has_relaxed;
}

// A vertex that was not reached, beside one that was. None once nothing is
// pending. O(1) where all vertices are reached.
template <typename Front>
std::optional<uint32_t> FindGap(const Front& front) {
  const Mesh& mesh = front.mesh();
  if (front.reached() == mesh.vertex_count()) return std::nullopt;
  for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (!std::isinf(front.distance(v))) continue;
    for (const HalfEdge h : mesh.Outgoing(v)) {
      for (const uint32_t corner : mesh.TriangleOf(h)) {
        if (!std::isinf(front.distance(corner))) return v;
      }
    }
  }
  return std::nullopt;
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_EDGE_RELAXATION_H_
