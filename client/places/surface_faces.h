// The faces of a mesh that are part of its surface.

#ifndef GEODESIC_CLIENT_PLACES_SURFACE_FACES_H_
#define GEODESIC_CLIENT_PLACES_SURFACE_FACES_H_

#include <cstdint>
#include <numeric>
#include <vector>

#include "geodesic_client/mesh.h"

namespace geodesic::client {

// Calls visit(face, joined) for each face that has three vertices once some are
// joined into others; `joined` are these. A face that has not is left out of
// the surface. O(V + F). REQUIRES: indices in range.
template <typename Visit>
void ForEachSurfaceFace(const MeshArrays& mesh, Visit visit) {
  std::vector<uint32_t> into;
  if (!mesh.joined.empty()) {
    into.resize(mesh.positions.size());
    std::iota(into.begin(), into.end(), 0u);
    for (const auto& [vertex, place] : mesh.joined) into[vertex] = place;
  }
  for (uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    Triangle joined = mesh.triangles[face];
    if (!into.empty()) {
      for (uint32_t& vertex : joined) vertex = into[vertex];
    }
    const auto& [a, b, c] = joined;
    if (a != b && b != c && c != a) visit(face, joined);
  }
}

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PLACES_SURFACE_FACES_H_
