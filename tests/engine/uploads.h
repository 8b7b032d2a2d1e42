// Meshes on their way into an engine.

#ifndef GEODESIC_TESTS_ENGINE_UPLOADS_H_
#define GEODESIC_TESTS_ENGINE_UPLOADS_H_

#include <string>

#include "absl/strings/str_cat.h"
#include "geodesic/triangle_soup.h"
#include "server/engine/meshes/mesh_catalogue.h"

namespace geodesic::server::test {

// The canonical arrays as they travel.
inline std::string ArrayBytes(const TriangleSoup& soup) {
  std::string bytes(reinterpret_cast<const char*>(soup.positions.data()),
                    soup.positions.size() * sizeof(Point));
  bytes.append(reinterpret_cast<const char*>(soup.triangles.data()),
               soup.triangles.size() * sizeof(Triangle));
  return bytes;
}

inline UploadHeader ArrayHeader(const TriangleSoup& soup) {
  return {.format = kArrays,
          .size_bytes = ArrayBytes(soup).size(),
          .vertex_count = soup.positions.size(),
          .face_count = soup.triangles.size()};
}

// Coordinates are rounded to six digits.
inline std::string OffFile(const TriangleSoup& soup) {
  std::string file = absl::StrCat("OFF\n", soup.positions.size(), " ",
                                  soup.triangles.size(), " 0\n");
  for (const Point& p : soup.positions) {
    absl::StrAppend(&file, p[0], " ", p[1], " ", p[2], "\n");
  }
  for (const Triangle& t : soup.triangles) {
    absl::StrAppend(&file, "3 ", t[0], " ", t[1], " ", t[2], "\n");
  }
  return file;
}

// A tetrahedron as an OFF file and as arrays.
inline constexpr char kTetrahedronOff[] =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
    "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

inline TriangleSoup Tetrahedron() {
  return {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          .triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

inline UploadHeader TetrahedronOffHeader() {
  return {.format = MeshFormat::kOff,
          .size_bytes = sizeof(kTetrahedronOff) - 1};
}

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_ENGINE_UPLOADS_H_
