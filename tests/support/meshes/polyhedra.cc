#include "tests/support/meshes/polyhedra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "tests/support/vec.h"

namespace geodesic::test {

Polyhedron Tetrahedron() {
  return {"tetrahedron",
          {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

Polyhedron Octahedron() {
  const std::vector<std::vector<uint32_t>> faces = {
      {0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return {"octahedron",
          {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          faces};
}

Polyhedron Icosahedron() {
  const double phi = std::numbers::phi;
  const std::vector<Point> vertices = {
      {-1, phi, 0}, {1, phi, 0}, {-1, -phi, 0}, {1, -phi, 0},
      {0, -1, phi}, {0, 1, phi}, {0, -1, -phi}, {0, 1, -phi},
      {phi, 0, -1}, {phi, 0, 1}, {-phi, 0, -1}, {-phi, 0, 1}};
  return {"icosahedron",
          vertices,
          {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
           {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
           {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
           {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
}

Polyhedron Box(double a, double b, double c) {
  const std::vector<Point> vertices = {{0, 0, 0}, {a, 0, 0}, {a, b, 0},
                                       {0, b, 0}, {0, 0, c}, {a, 0, c},
                                       {a, b, c}, {0, b, c}};
  const std::vector<std::vector<uint32_t>> faces = {{0, 3, 2, 1}, {4, 5, 6, 7},
                                                    {0, 1, 5, 4}, {1, 2, 6, 5},
                                                    {2, 3, 7, 6}, {3, 0, 4, 7}};
  return {"box", vertices, faces};
}

TriangleSoup Triangulate(const Polyhedron& polyhedron) {
  TriangleSoup soup{.positions = polyhedron.vertices};
  for (const std::vector<uint32_t>& face : polyhedron.faces) {
    for (size_t i = 2; i < face.size(); ++i) {
      soup.triangles.push_back({face[0], face[i - 1], face[i]});
    }
  }
  return soup;
}

TriangleSoup BoxGrid(double a, double b, double c, uint32_t na, uint32_t nb,
                     uint32_t nc) {
  using GridPoint = std::array<uint32_t, 3>;
  const GridPoint counts = {na, nb, nc};
  const Point lengths = {a, b, c};
  TriangleSoup soup;
  std::map<GridPoint, uint32_t> numbers;
  const auto number = [&](const GridPoint& g) {
    const auto [it, is_new] =
        numbers.emplace(g, static_cast<uint32_t>(soup.positions.size()));
    if (is_new) {
      Point& p = soup.positions.emplace_back();
      for (int i = 0; i < 3; ++i) p[i] = lengths[i] * g[i] / counts[i];
    }
    return it->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool far : {false, true}) {
      for (uint32_t i = 0; i < counts[u]; ++i) {
        for (uint32_t j = 0; j < counts[v]; ++j) {
          GridPoint g{};
          g[axis] = far ? counts[axis] : 0;
          std::array<uint32_t, 4> corners;
          for (int k = 0; k < 4; ++k) {
            g[u] = i + (k == 1 || k == 2 ? 1 : 0);
            g[v] = j + (k >= 2 ? 1 : 0);
            corners[far ? k : 3 - k] = number(g);
          }
          soup.triangles.push_back({corners[0], corners[1], corners[2]});
          soup.triangles.push_back({corners[0], corners[2], corners[3]});
        }
      }
    }
  }
  return soup;
}

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
      const Vec3 u = Along(f, 0);
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

  // The direction of side i.
  Vec3 Along(size_t f, size_t i) const {
    const Vec3 edge = Corner(f, i + 1) - Corner(f, i);
    return (1 / Norm(edge)) * edge;
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
      const Vec3 u = Along(f, i);
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
        const Vec3 u = Along(g, i);
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
