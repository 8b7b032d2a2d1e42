#include "tests/integration/planar_grid_test.h"

#include <sstream>

#include "tests/support/surface_points.h"

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
  const test::Vec3 at = test::PositionIn(
      {.positions = mesh_.positions, .triangles = mesh_.triangles}, point);
  return {static_cast<double>(at.x), static_cast<double>(at.y),
          static_cast<double>(at.z)};
}

}  // namespace geodesic::client
