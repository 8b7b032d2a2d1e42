// Where a path begins, bends or ends.

#ifndef GEODESIC_QUESTIONS_FIRST_PATH_PLACE_H_
#define GEODESIC_QUESTIONS_FIRST_PATH_PLACE_H_

#include <cstdint>
#include <variant>

#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "solver/windows/window.h"
#include "surface/plane_point.h"
#include "surface/surface_location.h"

namespace geodesic {

// A vertex, or a point of a face.
struct Place {
  static constexpr uint32_t kNoVertex = 0xffffffffu;

  uint32_t vertex = kNoVertex;
  FacePoint point;  // if it is no vertex

  static Place At(uint32_t vertex) { return {.vertex = vertex}; }
  // A point on an edge counts as one of a face beside it. O(valence).
  static Place Of(const Mesh& mesh, const SurfacePoint& point) {
    if (const auto* at = std::get_if<VertexPoint>(&point)) {
      return At(at->vertex);
    }
    return {.point = FirstFaceAround(mesh, point)};
  }

  bool is_vertex() const { return vertex != kNoVertex; }

  // Whether it is the apex of the face of h, or a point of that face.
  bool LiesAcross(const Mesh& mesh, HalfEdge h) const {
    return is_vertex() ? mesh.Apex(h) == vertex : mesh.FaceOf(h) == point.face;
  }
  // In the frame of h. REQUIRES: LiesAcross.
  PlanePoint Across(const Mesh& mesh, HalfEdge h) const {
    if (!is_vertex()) return InFrame(mesh, point, h);
    return ApexOf(mesh.frame(h));
  }
  // Whether it is an end of h.
  bool EndsAt(const Mesh& mesh, HalfEdge h) const {
    return is_vertex() && (mesh.From(h) == vertex || mesh.To(h) == vertex);
  }
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_FIRST_PATH_PLACE_H_
