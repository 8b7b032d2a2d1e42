#include "client/picture/nearest_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace geodesic::client {
namespace {

// Two triangles of a plane, 0-1-2 and 2-1-3, with sources at corners 0 and 3.
const MeshArrays kSquare = {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}},
                            {{0, 1, 2}, {2, 1, 3}}};

TEST(NearestCellsTest, WithinATriangleTheNearestOfItsCornersSourcesWins) {
  // Vertices 1 and 2 are as far from both sources, and belong to the first.
  const std::vector<double> distances = {0, 2, 2, 0};
  const std::vector<uint32_t> nearest = {5, 5, 5, 7};
  const NearestCells cells(kSquare, distances, nearest);
  EXPECT_EQ(cells.At({0, 1, 2}, {0.1, 0.45, 0.45}).source, 5);
  // The other triangle is nearer to 7 all over.
  for (const double to_3 : {0.01, 0.3, 0.9}) {
    const double rest = (1 - to_3) / 2;
    const NearestCells::Nearest found = cells.At({2, 1, 3}, {rest, rest, to_3});
    EXPECT_EQ(found.source, 7) << to_3;
    EXPECT_DOUBLE_EQ(found.corner_distances[0], 2);
    EXPECT_DOUBLE_EQ(found.corner_distances[1], 2);
    EXPECT_DOUBLE_EQ(found.corner_distances[2], 0);
  }
}

TEST(NearestCellsTest, UnfoldsOverASideInAnyUnit) {
  // Folded along 1-2, which changes no distance. Vertex 3 is nearest to a
  // source of its own; from 0 it is sqrt(8) away, straight over the side.
  for (const double unit : {1e-200, 1.0, 1e200}) {
    MeshArrays folded = kSquare;
    folded.positions[3] = {1, 1, std::sqrt(2)};
    for (Point& point : folded.positions) {
      for (double& coordinate : point) coordinate *= unit;
    }
    const std::vector<double> distances = {0, 2 * unit, 2 * unit, unit};
    const std::vector<uint32_t> nearest = {0, 0, 0, 1};
    const NearestCells cells(folded, distances, nearest);
    // Half way from 1 to 2: sqrt(2) from source 0, less than from the other.
    const NearestCells::Nearest found = cells.At({2, 1, 3}, {0.5, 0.5, 0});
    EXPECT_EQ(found.source, 0);
    EXPECT_NEAR(found.corner_distances[2] / unit, std::sqrt(8), 1e-12);
  }
}

TEST(NearestCellsTest, OneSourceHasItsCellWhole) {
  const std::vector<double> distances = {0, 2, 2, 3};
  const std::vector<uint32_t> nearest = {4, 4, 4, 4};
  const NearestCells cells(kSquare, distances, nearest);
  const NearestCells::Nearest found = cells.At({2, 1, 3}, {0.2, 0.2, 0.6});
  EXPECT_EQ(found.source, 4);
  EXPECT_EQ(found.corner_distances, (std::array<double, 3>{2, 2, 3}));
}

}  // namespace
}  // namespace geodesic::client
