// What a pseudo-source leads to.

#ifndef GEODESIC_SOLVER_RULES_EXPANSION_H_
#define GEODESIC_SOLVER_RULES_EXPANSION_H_

#include <cstdint>

#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "solver/rules/shadow_fan.h"
#include "solver/rules/sight.h"
#include "solver/windows/window.h"

namespace geodesic {

// Relaxes the neighbours of v. Sink has Relax, as Front has.
template <typename Front, typename Sink>
void RelaxAround(const Front& front, uint32_t v, Sink& sink) {
  const Mesh& mesh = front.mesh();
  const double sigma = front.distance(v);
  const Arrival along_edge{.pseudo_source = v};
  for (HalfEdge h : mesh.Outgoing(v)) {
    sink.Relax(mesh.To(h), sigma + mesh.frame(h).length, along_edge,
               IncomingRay::Along(h));
    // Elsewhere another of them leads to the apex.
    if (mesh.Twin(Prev(h)) != kNoHalfEdge) continue;
    sink.Relax(mesh.Apex(h), sigma + mesh.frame(Prev(h)).length, along_edge,
               IncomingRay::Along(Prev(h)));
  }
}

// Calls visit(h, part) for the half-edges that leave v and in whose face
// something is to be seen from v: in that part of the edge opposite to v.
template <typename Front, typename Visit>
void ForEachSeen(const Front& front, uint32_t v, Visit visit) {
  const Mesh& mesh = front.mesh();
  if (!front.SeesAllAround(v)) {
    ShadowFan(mesh, v, front.IncomingAt(v)).ForEachFace(visit);
    return;
  }
  for (HalfEdge h : mesh.Outgoing(v)) {
    if (mesh.IsCopy(h)) continue;
    visit(h, Interval{0, mesh.frame(Next(h)).length});
  }
}

// Opens what is seen there. `sigma`: the distance of the vertex that h leaves,
// whose sight it is.
template <typename SightType>
void LookAcross(const Mesh& mesh, HalfEdge h, const Interval& part,
                double sigma, SightType& sight) {
  const HalfEdge opposite = Next(h);
  const HalfEdgeFrame& frame = mesh.frame(opposite);
  // Seen from beyond, the edge runs the other way.
  sight.Across(
      opposite,
      {.x = frame.length - frame.apex_x, .depth = frame.apex_y, .sigma = sigma},
      Mirror(part, frame.length));
}

// What the event of v leads to: relaxes v's neighbours along their edges and
// opens every edge that v sees whole, where the half-edge enters the face
// beyond. These are the edges opposite to v, and where v lies on one (across a
// face without area), the other edges of the face beyond. Sink has Relax and
// Observe, as Front has, and Open, as rules have. Returns how many faces were
// looked at beyond irregular edges.
template <typename Front, typename Sink>
uint64_t Expand(const Front& front, uint32_t v, Sink& sink) {
  RelaxAround(front, v, sink);
  Sight sight(front, v, sink);
  ForEachSeen(front, v,
              [&, sigma = front.distance(v)](HalfEdge h, const Interval& part) {
                LookAcross(front.mesh(), h, part, sigma, sight);
              });
  return sight.faces();
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_EXPANSION_H_
