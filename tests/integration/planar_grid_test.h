// A planar grid on a server: geodesic distance on it is Euclid's.

#ifndef GEODESIC_TESTS_INTEGRATION_PLANAR_GRID_TEST_H_
#define GEODESIC_TESTS_INTEGRATION_PLANAR_GRID_TEST_H_

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "geodesic_client/client.h"
#include "tests/integration/meshes.h"
#include "tests/integration/running_server.h"

namespace geodesic::client {

inline constexpr double kTolerance = 1e-10;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Squares along a side, and the middle of the grid.
inline constexpr uint32_t kGrid = 8;
inline constexpr uint32_t kVertices = (kGrid + 1) * (kGrid + 1);
inline constexpr uint32_t kMiddle = (kGrid / 2) * (kGrid + 2);

inline double Euclid(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The numbers of a .csv, without its header.
std::vector<std::vector<double>> Rows(const std::string& csv);

class PlanarGridTest : public IntegrationTest {
 protected:
  void SetUp() override;

  const Point& At(uint64_t vertex) const { return mesh_.positions.at(vertex); }

  // Where a point lies, from its definition.
  Point Where(const SurfacePoint& point) const;

  MeshArrays mesh_ = PlanarGrid(kGrid);
  std::string digest_ = MeshDigest(mesh_);
  // The mesh as a file; it is resident too.
  std::string grid_ = folder_ / "grid.off";
  Client client_{server_.address()};
  const uint64_t vertex_count_ = mesh_.positions.size();
  // In a face, on the diagonal of the first square, and at a corner.
  const std::vector<SurfacePoint> places_ = {FacePoint{40, {0.2, 0.3, 0.5}},
                                             EdgePoint{0, kGrid + 2, 0.25},
                                             VertexPoint{kGrid}};
};

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_INTEGRATION_PLANAR_GRID_TEST_H_
