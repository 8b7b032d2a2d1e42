// Where a surface point lies, for the solver: the faces around it and its place
// in their frames.

#ifndef GEODESIC_SURFACE_SURFACE_LOCATION_H_
#define GEODESIC_SURFACE_SURFACE_LOCATION_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "surface/plane_point.h"

namespace geodesic {

// Calls visit(half_edge) for the half-edges, one a face, that run along the
// edge between two vertices in either direction, in order of faces, until it
// returns true; whether it did. O(the lesser valence).
template <typename Visit>
bool VisitSides(const Mesh& mesh, uint32_t from, uint32_t to, Visit visit) {
  if (mesh.Outgoing(to).size() < mesh.Outgoing(from).size()) {
    std::swap(from, to);
  }
  for (const HalfEdge h : mesh.Outgoing(from)) {
    if (mesh.To(h) == to && visit(h)) return true;
    if (mesh.Apex(h) == to && visit(Prev(h))) return true;
  }
  return false;
}

// All of them; none if there is no such edge.
std::vector<HalfEdge> SidesOf(const Mesh& mesh, uint32_t from, uint32_t to);

// Calls visit(point) for the point as weights in every face around it, in order
// of faces, until it returns true; whether it did. O(valence), of an edge the
// lesser of its ends.
template <typename Visit>
bool VisitFacesAround(const Mesh& mesh, const SurfacePoint& point,
                      Visit visit) {
  FacePoint at;
  const auto visit_at = [&](HalfEdge h, double from, double to) {
    at.face = mesh.FaceOf(h);
    at.weights = {};
    at.weights[h % 3] = from;
    at.weights[Next(h) % 3] = to;
    return visit(std::as_const(at));
  };
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    for (const HalfEdge h : mesh.Outgoing(vertex->vertex)) {
      if (visit_at(h, 1, 0)) return true;
    }
    return false;
  }
  if (const auto* edge = std::get_if<EdgePoint>(&point)) {
    return VisitSides(mesh, edge->from, edge->to, [&](HalfEdge h) {
      return mesh.From(h) == edge->from ? visit_at(h, 1 - edge->t, edge->t)
                                        : visit_at(h, edge->t, 1 - edge->t);
    });
  }
  return visit(std::get<FacePoint>(point));
}

// All of them, and the first of them; of a vertex that REQUIRES a face.
std::vector<FacePoint> FacesAround(const Mesh& mesh, const SurfacePoint& point);
FacePoint FirstFaceAround(const Mesh& mesh, const SurfacePoint& point);

// The point as weights in `face`, if it lies there: at a corner, on a side or
// inside. O(1).
std::optional<FacePoint> WithinFace(const Mesh& mesh, const SurfacePoint& point,
                                    uint32_t face);

// No more faces lie around the point. O(1).
size_t MostFacesAround(const Mesh& mesh, const SurfacePoint& point);

// Calls visit(a, b) for two points as weights in every face where both lie, in
// order of faces, until it returns true; whether it did. O(the least valence).
template <typename Visit>
bool VisitSharedFaces(const Mesh& mesh, const SurfacePoint& a,
                      const SurfacePoint& b, Visit visit) {
  if (MostFacesAround(mesh, b) < MostFacesAround(mesh, a)) {
    return VisitFacesAround(mesh, b, [&](const FacePoint& at_b) {
      const auto at_a = WithinFace(mesh, a, at_b.face);
      return at_a.has_value() && visit(*at_a, at_b);
    });
  }
  return VisitFacesAround(mesh, a, [&](const FacePoint& at_a) {
    const auto at_b = WithinFace(mesh, b, at_a.face);
    return at_b.has_value() && visit(at_a, *at_b);
  });
}

// The side that holds two points of a face, if there is one: they leave out the
// same corner.
std::optional<HalfEdge> SharedSide(const Mesh& mesh, const FacePoint& a,
                                   const FacePoint& b);

// The point in the frame of one of its face's half-edges, in the scaled unit.
PlanePoint InFrame(const Mesh& mesh, const FacePoint& point, HalfEdge h);

// Distance from the point straight to a corner of its face.
double DistanceToCorner(const Mesh& mesh, const FacePoint& point,
                        uint32_t corner);

}  // namespace geodesic

#endif  // GEODESIC_SURFACE_SURFACE_LOCATION_H_
