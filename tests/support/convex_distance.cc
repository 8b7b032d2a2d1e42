#include <algorithm>
#include <limits>
#include <optional>

#include "tests/support/polyhedra.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

// How far from a face a point may lie and still be on it, and how far beside
// a portal's corner a line may pass: relative to coordinates near 1, the
// rounding of the points given.
constexpr Real kSlack = 1e-13L;

// A face laid into the plane: its point `origin` is at `at`, and its
// orthonormal directions u, v become a, b.
struct Placement {
  Vec3 origin, u, v;
  Vec2 at, a, b;

  Vec2 operator()(Vec3 p) const {
    return at + Dot(p - origin, u) * a + Dot(p - origin, v) * b;
  }
};

class ConvexUnfolder {
 public:
  ConvexUnfolder(const Polyhedron& polyhedron, const Point& p, const Point& q)
      : polyhedron_(polyhedron),
        p_(ToVec3(p)),
        q_(ToVec3(q)),
        visited_(polyhedron.faces.size(), false),
        best_(std::numeric_limits<Real>::infinity()) {}

  Real Distance() {
    for (size_t f = 0; f < polyhedron_.faces.size(); ++f) {
      if (!Contains(f, p_)) continue;
      const Vec3 origin = Corner(f, 0);
      const Vec3 edge = Corner(f, 1) - origin;
      const Vec3 u = (1 / Norm(edge)) * edge;
      const Vec3 v = Inward(f, 0, u);
      const Placement flat{origin, u, v, {}, {1, 0}, {0, 1}};
      // The source goes to the origin.
      Placement placed = flat;
      placed.at = Vec2{} - flat(p_);
      Enter(f, placed, std::nullopt);
    }
    return best_;
  }

 private:
  struct Wedge {
    Vec2 right, left;
  };

  size_t Corners(size_t f) const { return polyhedron_.faces[f].size(); }
  uint32_t CornerNumber(size_t f, size_t i) const {
    return polyhedron_.faces[f][i % Corners(f)];
  }
  Vec3 Corner(size_t f, size_t i) const {
    return ToVec3(polyhedron_.vertices[CornerNumber(f, i)]);
  }

  // The direction in face f, square to its side i with direction u, that
  // points into the face.
  Vec3 Inward(size_t f, size_t i, Vec3 u) const {
    const Vec3 e = Corner(f, i + 2) - Corner(f, i);
    const Vec3 across = e - Dot(e, u) * u;
    return (1 / Norm(across)) * across;
  }

  bool Contains(size_t f, Vec3 p) const {
    for (size_t i = 0; i < Corners(f); ++i) {
      const Vec3 edge = Corner(f, i + 1) - Corner(f, i);
      const Vec3 u = (1 / Norm(edge)) * edge;
      const Vec3 v = Inward(f, i, u);
      const Vec3 d = p - Corner(f, i);
      if (Dot(d, v) < -kSlack) return false;
      if (std::abs(Dot(d, Cross(u, v))) > kSlack) return false;
    }
    return true;
  }

  // Looks into face f through the wedge, or all around in a first face.
  void Enter(size_t f, const Placement& placed, std::optional<Wedge> wedge) {
    visited_[f] = true;
    if (Contains(f, q_)) {
      const Vec2 q = placed(q_);
      if (!wedge || (Cross(wedge->right, q) >= -kSlack * Norm(wedge->right) &&
                     Cross(q, wedge->left) >= -kSlack * Norm(wedge->left))) {
        best_ = std::min(best_, Norm(q));
      }
    }
    for (size_t i = 0; i < Corners(f); ++i) Leave(f, i, placed, wedge);
    visited_[f] = false;
  }

  void Leave(size_t f, size_t side, const Placement& placed,
             std::optional<Wedge> wedge) {
    const Vec2 a = placed(Corner(f, side)), b = placed(Corner(f, side + 1));
    // The source lies left of a -> b; on it, the face beyond is a first face.
    Wedge through{a, b};
    if (Cross(a, b) <= kSlack * Norm(b - a)) return;
    if (wedge) {
      if (Cross(wedge->right, a) < 0) through.right = wedge->right;
      if (Cross(b, wedge->left) < 0) through.left = wedge->left;
    }
    if (Cross(through.right, through.left) <= 0) return;
    for (size_t g = 0; g < polyhedron_.faces.size(); ++g) {
      if (visited_[g]) continue;
      for (size_t i = 0; i < Corners(g); ++i) {
        if (CornerNumber(g, i) != CornerNumber(f, side + 1) ||
            CornerNumber(g, i + 1) != CornerNumber(f, side)) {
          continue;
        }
        const Vec3 edge = Corner(g, i + 1) - Corner(g, i);
        const Vec3 u = (1 / Norm(edge)) * edge;
        const Vec2 flat = (1 / Norm(a - b)) * (a - b);
        // Face g lies left of b -> a, away from the source.
        Enter(g,
              {Corner(g, i), u, Inward(g, i, u), b, flat, Perpendicular(flat)},
              through);
      }
    }
  }

  const Polyhedron& polyhedron_;
  const Vec3 p_, q_;
  std::vector<bool> visited_;
  Real best_;
};

}  // namespace

double DistanceOnConvex(const Polyhedron& polyhedron, const Point& p,
                        const Point& q) {
  return static_cast<double>(ConvexUnfolder(polyhedron, p, q).Distance());
}

}  // namespace geodesic::test
