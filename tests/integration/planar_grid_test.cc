#include "tests/integration/planar_grid_test.h"

#include <sstream>
#include <utility>

namespace geodesic::client {

std::vector<std::vector<double>> Rows(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::vector<double>& row = rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) {
      row.push_back(std::strtod(cell.c_str(), nullptr));
    }
  }
  return rows;
}

void PlanarGridTest::SetUp() {
  WriteFile(grid_, OffText(mesh_));
  ASSERT_TRUE(client_.UploadArrays(mesh_).ok());
}

Point PlanarGridTest::Where(const SurfacePoint& point) const {
  std::vector<std::pair<double, uint64_t>> corners;
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    corners = {{1, vertex->vertex}};
  } else if (const auto* edge = std::get_if<EdgePoint>(&point)) {
    corners = {{1 - edge->t, edge->from}, {edge->t, edge->to}};
  } else {
    const auto& face = std::get<FacePoint>(point);
    for (int i = 0; i < 3; ++i) {
      corners.emplace_back(face.weights[i], mesh_.triangles[face.face][i]);
    }
  }
  Point sum = {};
  for (const auto& [weight, vertex] : corners) {
    for (int axis = 0; axis < 3; ++axis) sum[axis] += weight * At(vertex)[axis];
  }
  return sum;
}

std::string PlanarGridTest::Refusal(const std::vector<std::string>& words,
                                    int exit_code) const {
  const ProcessResult result = Geodesic(words);
  EXPECT_EQ(result.exit_code, exit_code) << result.out << result.err;
  return result.err;
}

}  // namespace geodesic::client
