#include "client/places/nearest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "client/picture/vector3.h"
#include "client/places/surface_faces.h"

namespace geodesic::client {
namespace {

// Scales the mesh and the wanted point into a cube of half size 1, and moves
// that point to the origin. A power of two rounds nothing, and squares then
// neither overflow nor vanish.
class Frame {
 public:
  Frame(const MeshArrays& mesh, const Point& origin) {
    double largest = 0;
    const auto add = [&largest](const Point& point) {
      for (const double x : point) largest = std::max(largest, std::abs(x));
    };
    add(origin);
    for (const Point& position : mesh.positions) add(position);
    if (largest > 0) {
      // Within the exponents of normal numbers.
      scale_ = std::ldexp(1, std::clamp(-std::ilogb(largest) - 1, -1022, 1022));
    }
    origin_ = Scaled(origin);
  }

  Vector3 Place(const Point& point) const { return Scaled(point) - origin_; }

 private:
  Vector3 Scaled(const Point& point) const {
    return {scale_ * point[0], scale_ * point[1], scale_ * point[2]};
  }

  double scale_ = 1;
  Vector3 origin_;
};

// The nearest point to the origin so far.
struct Nearest {
  double squared_distance = std::numeric_limits<double>::infinity();
  std::optional<SurfacePoint> point;

  // Takes a point that is nearer.
  void Offer(const Vector3& place, const SurfacePoint& candidate) {
    const double squared = Dot(place, place);
    if (squared >= squared_distance) return;
    squared_distance = squared;
    point = candidate;
  }
};

// Offers the point of the edge from `from` at `a` to `to` at `b`.
void OfferEdge(const Vector3& a, uint32_t from, const Vector3& b, uint32_t to,
               Nearest* nearest) {
  const Vector3 along = b - a;
  const double squared_length = Dot(along, along);
  const double t = squared_length > 0 ? -Dot(a, along) / squared_length : 0;
  if (t <= 0) {
    nearest->Offer(a, VertexPoint{from});
  } else if (t >= 1) {
    nearest->Offer(b, VertexPoint{to});
  } else {
    nearest->Offer(a + t * along, EdgePoint{from, to, t});
  }
}

// Offers the foot of the perpendicular on the face, if it is inside. Its
// distance is that of the point with these weights, so that a sliver's
// rounding errors cannot make it look nearer than it is.
void OfferInside(const std::array<Vector3, 3>& corners, uint32_t face,
                 Nearest* nearest) {
  const auto& [a, b, c] = corners;
  const Vector3 normal = Cross(b - a, c - a);
  const double squared = Dot(normal, normal);
  if (!(squared > 0)) return;
  const double wa = Dot(Cross(b, c), normal) / squared;
  const double wb = Dot(Cross(c, a), normal) / squared;
  const double wc = 1 - wa - wb;
  if (!(wa > 0 && wb > 0 && wc > 0)) return;
  nearest->Offer(wa * a + wb * b + wc * c, FacePoint{face, {wa, wb, wc}});
}

// At most the squared distance of the face from the origin: that of the box
// around it.
double LeastSquaredDistance(const std::array<Vector3, 3>& corners) {
  const auto gap = [](double a, double b, double c) {
    return std::max({0.0, std::min({a, b, c}), -std::max({a, b, c})});
  };
  const auto& [a, b, c] = corners;
  const Vector3 gaps = {gap(a.x, b.x, c.x), gap(a.y, b.y, c.y),
                        gap(a.z, b.z, c.z)};
  return Dot(gaps, gaps);
}

}  // namespace

absl::StatusOr<SurfacePoint> FindOnMesh(const MeshArrays& mesh,
                                        const NearestPoint& wanted) {
  const Frame frame(mesh, wanted.to);
  Nearest nearest;
  ForEachSurfaceFace(mesh, [&](uint32_t face, const Triangle&) {
    const Triangle& triangle = mesh.triangles[face];
    std::array<Vector3, 3> corners;
    for (size_t i = 0; i < 3; ++i) {
      corners[i] = frame.Place(mesh.positions[triangle[i]]);
    }
    if (LeastSquaredDistance(corners) >= nearest.squared_distance) return;
    for (size_t i = 0; i < 3; ++i) {
      const size_t j = (i + 1) % 3;
      OfferEdge(corners[i], triangle[i], corners[j], triangle[j], &nearest);
    }
    OfferInside(corners, face, &nearest);
  });
  if (!nearest.point.has_value()) {
    return absl::InvalidArgumentError(
        "nearest: the mesh has no faces, so no point of its surface is "
        "nearest; name a vertex");
  }
  return *nearest.point;
}

absl::StatusOr<SurfacePoint> FindOnMesh(const MeshArrays& mesh,
                                        const ExtremeVertex& wanted) {
  const auto is_before = [&](uint32_t a, uint32_t b) {
    const double at_a = mesh.positions[a][wanted.axis];
    const double at_b = mesh.positions[b][wanted.axis];
    if (at_a == at_b) return a < b;
    return wanted.is_greatest ? at_a > at_b : at_a < at_b;
  };
  std::optional<uint32_t> first;
  ForEachSurfaceFace(mesh, [&](uint32_t face, const Triangle&) {
    for (const uint32_t vertex : mesh.triangles[face]) {
      if (!first.has_value() || is_before(vertex, *first)) first = vertex;
    }
  });
  if (!first.has_value()) {
    return absl::InvalidArgumentError(
        "min, max: the mesh has no faces, so no vertex of its surface is "
        "outermost; name a vertex");
  }
  return VertexPoint{*first};
}

}  // namespace geodesic::client
