// Places on the surface of a mesh: points, curves and sources.

#ifndef GEODESIC_CLIENT_SURFACE_POINT_H_
#define GEODESIC_CLIENT_SURFACE_POINT_H_

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

namespace geodesic::client {

// Numbers of vertices and faces are 0-based.
struct VertexPoint {
  uint64_t vertex = 0;

  friend auto operator<=>(const VertexPoint&, const VertexPoint&) = default;
};

// The point (1 - t) * from + t * to of the edge between two vertices.
struct EdgePoint {
  uint64_t from = 0;
  uint64_t to = 0;
  double t = 0;  // in [0, 1]

  friend auto operator<=>(const EdgePoint&, const EdgePoint&) = default;
};

// The point sum of weights[i] * corner i of a face.
struct FacePoint {
  uint64_t face = 0;
  // Barycentric: each >= 0; their sum is 1 within 2e-6.
  std::array<double, 3> weights{};

  friend auto operator<=>(const FacePoint&, const FacePoint&) = default;
};

// A place on the surface.
using SurfacePoint = std::variant<VertexPoint, EdgePoint, FacePoint>;

// A polyline on the surface. Points that follow each other lie in a common
// face, where the segment between them runs straight.
struct Curve {
  std::vector<SurfacePoint> points;  // at least one

  friend bool operator==(const Curve&, const Curve&) = default;
};

// Distances are measured from a source, which is a point or every point of a
// curve. The sources of a query are numbered from 0 in their order.
struct Source {
  std::variant<VertexPoint, EdgePoint, FacePoint, Curve> place;
  // Added to all distances from the source; in the unit of the mesh, finite, >=
  // 0.
  double offset = 0;

  friend bool operator==(const Source&, const Source&) = default;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_SURFACE_POINT_H_
