#include "client/picture/corner_normals.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "client/picture/vector3.h"

namespace geodesic::client {
namespace {

constexpr double kCosCrease = 0.766;  // 40 degrees.
constexpr ptrdiff_t kMostTriangles = 64;

Vector3 ToVector(const Point& point) { return {point[0], point[1], point[2]}; }

// A factor that brings the corners' coordinates to a magnitude of at most 1.
// Vertices without triangles do not count.
double InverseMagnitude(const MeshArrays& mesh) {
  double largest = 0;
  for (const Triangle& triangle : mesh.triangles) {
    for (const uint32_t vertex : triangle) {
      for (const double value : mesh.positions[vertex]) {
        largest = std::max(largest, std::abs(value));
      }
    }
  }
  return largest > 0 ? 1 / largest : 1;
}

// Each triangle's normal; its length is twice the area, in scaled units.
std::vector<Vector3> FaceNormals(const MeshArrays& mesh) {
  const double scale = InverseMagnitude(mesh);
  std::vector<Vector3> normals;
  normals.reserve(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    const Vector3 a = scale * ToVector(mesh.positions[triangle[0]]);
    const Vector3 b = scale * ToVector(mesh.positions[triangle[1]]);
    const Vector3 c = scale * ToVector(mesh.positions[triangle[2]]);
    normals.push_back(Cross(b - a, c - a));
  }
  return normals;
}

// The triangles at each vertex: those of v are at[first[v]] to
// at[first[v + 1] - 1].
struct Incidence {
  std::vector<size_t> first;
  std::vector<uint32_t> at;
};

Incidence VertexTriangles(const MeshArrays& mesh) {
  Incidence incidence;
  incidence.first.assign(mesh.positions.size() + 1, 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (const uint32_t vertex : triangle) ++incidence.first[vertex + 1];
  }
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    incidence.first[v + 1] += incidence.first[v];
  }
  incidence.at.resize(3 * mesh.triangles.size());
  std::vector<size_t> next(incidence.first.begin(), incidence.first.end() - 1);
  for (uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    for (const uint32_t vertex : mesh.triangles[face]) {
      incidence.at[next[vertex]++] = face;
    }
  }
  return incidence;
}

// The sum of those face normals in [begin, end) that are on one smooth sheet
// with `own`.
Vector3 CreasedSum(const Vector3& own, const std::vector<Vector3>& face_normals,
                   const uint32_t* begin, const uint32_t* end) {
  Vector3 sum;
  for (const uint32_t* face = begin; face != end; ++face) {
    const Vector3& other = face_normals[*face];
    const double cosine = Dot(own, Normalized(other));
    if (cosine > kCosCrease) {
      sum = sum + other;
    } else if (cosine < -kCosCrease) {
      sum = sum - other;  // The same sheet, wound the other way.
    }
  }
  return sum;
}

}  // namespace

std::vector<std::array<Normal, 3>> CornerNormals(const MeshArrays& mesh) {
  const std::vector<Vector3> face_normals = FaceNormals(mesh);
  const Incidence incidence = VertexTriangles(mesh);
  std::vector<Vector3> whole_sums(mesh.positions.size());
  for (size_t face = 0; face < mesh.triangles.size(); ++face) {
    for (const uint32_t vertex : mesh.triangles[face]) {
      whole_sums[vertex] = whole_sums[vertex] + face_normals[face];
    }
  }
  std::vector<std::array<Normal, 3>> normals(mesh.triangles.size());
  for (size_t face = 0; face < mesh.triangles.size(); ++face) {
    const Vector3 own = Normalized(face_normals[face]);
    for (int corner = 0; corner < 3; ++corner) {
      const uint32_t vertex = mesh.triangles[face][corner];
      const uint32_t* begin = incidence.at.data() + incidence.first[vertex];
      const uint32_t* end = incidence.at.data() + incidence.first[vertex + 1];
      const Vector3 unit =
          Normalized(end - begin > kMostTriangles
                         ? whole_sums[vertex]
                         : CreasedSum(own, face_normals, begin, end));
      normals[face][corner] = {static_cast<float>(unit.x),
                               static_cast<float>(unit.y),
                               static_cast<float>(unit.z)};
    }
  }
  return normals;
}

}  // namespace geodesic::client
