#include "surface/surface_location.h"

#include <algorithm>
#include <cmath>

namespace geodesic {

std::vector<HalfEdge> SidesOf(const Mesh& mesh, uint32_t from, uint32_t to) {
  std::vector<HalfEdge> sides;
  VisitSides(mesh, from, to, [&](HalfEdge h) {
    sides.push_back(h);
    return false;
  });
  return sides;
}

std::vector<FacePoint> FacesAround(const Mesh& mesh,
                                   const SurfacePoint& point) {
  std::vector<FacePoint> faces;
  VisitFacesAround(mesh, point, [&](const FacePoint& at) {
    faces.push_back(at);
    return false;
  });
  return faces;
}

FacePoint FirstFaceAround(const Mesh& mesh, const SurfacePoint& point) {
  FacePoint first;
  VisitFacesAround(mesh, point, [&](const FacePoint& at) {
    first = at;
    return true;
  });
  return first;
}

size_t MostFacesAround(const Mesh& mesh, const SurfacePoint& point) {
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    return mesh.Outgoing(vertex->vertex).size();
  }
  if (const auto* edge = std::get_if<EdgePoint>(&point)) {
    return std::min(mesh.Outgoing(edge->from).size(),
                    mesh.Outgoing(edge->to).size());
  }
  return 1;
}

std::optional<FacePoint> WithinFace(const Mesh& mesh, const SurfacePoint& point,
                                    uint32_t face) {
  if (const auto* inside = std::get_if<FacePoint>(&point)) {
    if (inside->face != face) return std::nullopt;
    return *inside;
  }
  const Triangle& corners = mesh.triangle(face);
  FacePoint found{.face = face};
  const auto give = [&](uint32_t vertex, double weight) {
    const auto corner = std::ranges::find(corners, vertex);
    if (corner == corners.end()) return false;
    found.weights[corner - corners.begin()] = weight;
    return true;
  };
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    if (!give(vertex->vertex, 1)) return std::nullopt;
  } else {
    const auto& [from, to, t] = std::get<EdgePoint>(point);
    if (!give(from, 1 - t) || !give(to, t)) return std::nullopt;
  }
  return found;
}

std::optional<HalfEdge> SharedSide(const Mesh& mesh, const FacePoint& a,
                                   const FacePoint& b) {
  for (uint32_t corner = 0; corner < 3; ++corner) {
    if (a.weights[corner] == 0 && b.weights[corner] == 0) {
      return Next(mesh.FirstSide(a.face) + corner);
    }
  }
  return std::nullopt;
}

PlanePoint InFrame(const Mesh& mesh, const FacePoint& point, HalfEdge h) {
  const HalfEdgeFrame& frame = mesh.frame(h);
  const double at_b = point.weights[Next(h) % 3];
  const double at_c = point.weights[Prev(h) % 3];
  return {at_b * frame.length + at_c * frame.apex_x, at_c * frame.apex_y};
}

double DistanceToCorner(const Mesh& mesh, const FacePoint& point,
                        uint32_t corner) {
  const PlanePoint at =
      InFrame(mesh, point, mesh.FirstSide(point.face) + corner);
  return std::sqrt(at.x * at.x + at.y * at.y);
}

}  // namespace geodesic
