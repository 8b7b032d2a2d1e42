// Places on the surface of a mesh: points, curves and sources.

#ifndef GEODESIC_TYPES_PLACES_H_
#define GEODESIC_TYPES_PLACES_H_

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

namespace geodesic {

// A point in space, in the unit of the mesh's file.
using Point = std::array<double, 3>;

// A vertex, numbered from 0.
struct VertexPoint {
  uint32_t vertex = 0;

  friend auto operator<=>(const VertexPoint&, const VertexPoint&) = default;
};

// The point (1 - t) * from + t * to of the edge between two vertices.
struct EdgePoint {
  uint32_t from = 0;
  uint32_t to = 0;
  double t = 0;  // in [0, 1]

  friend auto operator<=>(const EdgePoint&, const EdgePoint&) = default;
};

// The point sum_i weights[i] * corner i of the face.
struct FacePoint {
  uint32_t face = 0;
  // Barycentric: each >= 0; their sum is 1 within kWeightSumTolerance.
  std::array<double, 3> weights{};

  friend auto operator<=>(const FacePoint&, const FacePoint&) = default;
};

// How far the sum of weights may be from 1: three that were rounded to six
// digits are off by 1.5e-6 at the most. They are divided by their sum.
inline constexpr double kWeightSumTolerance = 2e-6;

// A place on the surface.
using SurfacePoint = std::variant<VertexPoint, EdgePoint, FacePoint>;

// Two places whose distance is asked for. It is the same in both directions.
struct PointPair {
  SurfacePoint source;
  SurfacePoint target;

  friend auto operator<=>(const PointPair&, const PointPair&) = default;
};

// A polyline on the surface. Points that follow each other lie in a common
// face, where the segment between them runs straight. If several faces hold
// both points, there is a segment in each of them.
struct Curve {
  std::vector<SurfacePoint> points;  // at least one

  friend auto operator<=>(const Curve&, const Curve&) = default;
};

// Distances are measured from a source, which is a point or every point of a
// curve. The sources of a question are numbered from 0 in their order.
struct Source {
  std::variant<SurfacePoint, Curve> place;
  // Added to all distances from the source. In the unit of the mesh's file;
  // finite, >= 0, and at most about 1e6 times the mesh's extent, since rounding
  // would swamp the mesh beside a larger one.
  double offset = 0;

  friend auto operator<=>(const Source&, const Source&) = default;
};

// Stands for the number of a source where no path leads.
inline constexpr uint32_t kNoSource = 0xffffffffu;

// Whether the source is a curve, not a point.
inline bool IsCurve(const Source& source) {
  return std::holds_alternative<Curve>(source.place);
}

// The source's point, or its curve's first.
inline const SurfacePoint& FirstPoint(const Source& source) {
  const auto* point = std::get_if<SurfacePoint>(&source.place);
  return point != nullptr ? *point : std::get<Curve>(source.place).points.at(0);
}

// The vertex that a point is, or null.
inline const VertexPoint* AsVertex(const SurfacePoint& point) {
  return std::get_if<VertexPoint>(&point);
}
inline const VertexPoint* AsVertex(const Source& source) {
  const auto* point = std::get_if<SurfacePoint>(&source.place);
  return point != nullptr ? AsVertex(*point) : nullptr;
}

}  // namespace geodesic

#endif  // GEODESIC_TYPES_PLACES_H_
