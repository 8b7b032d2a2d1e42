// Solves a regular tetrahedron with the installed library. Every pair of its
// vertices shares an edge, which is the shortest path in space, hence on the
// surface.

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string_view>

#include "geodesic/mesh.h"
#include "geodesic/read_mesh.h"
#include "geodesic/solve.h"

namespace {

constexpr std::string_view kTetrahedron = R"(OFF
4 4 0
0 0 0
1 1 0
1 0 1
0 1 1
3 0 1 2
3 0 3 1
3 0 2 3
3 1 3 2
)";

absl::StatusOr<geodesic::DistanceField> SolveTetrahedron() {
  absl::StatusOr<geodesic::TriangleSoup> soup =
      geodesic::ReadMesh(kTetrahedron, geodesic::MeshFormat::kOff);
  if (!soup.ok()) return soup.status();
  absl::StatusOr<std::shared_ptr<const geodesic::Mesh>> mesh =
      geodesic::Mesh::Build(*std::move(soup));
  if (!mesh.ok()) return mesh.status();
  geodesic::NoCheckpoint checkpoint;
  return geodesic::Solve(**mesh, {.sources = {{geodesic::VertexPoint{0}}}}, {},
                         checkpoint);
}

}  // namespace

int main() {
  const absl::StatusOr<geodesic::DistanceField> field = SolveTetrahedron();
  if (!field.ok()) {
    std::fprintf(stderr, "%s\n", field.status().ToString().c_str());
    return 1;
  }
  const double edge = std::sqrt(2.0);
  const std::array expected = {0.0, edge, edge, edge};
  bool right = field->distances.size() == expected.size();
  for (size_t v = 0; right && v < expected.size(); ++v) {
    std::printf("distance to vertex %zu: %.17g\n", v, field->distances[v]);
    right = std::abs(field->distances[v] - expected[v]) <= 1e-10 * edge;
  }
  return right ? 0 : 1;
}
