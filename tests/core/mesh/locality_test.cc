#include "mesh/locality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace geodesic {
namespace {

// Small triangles at these places along the x axis, in a box of side 1.
TriangleSoup TrianglesAt(const std::vector<double>& places) {
  TriangleSoup soup{{{0, 0, 0}, {1, 1, 1}, {1, 0, 1}}, {}};
  for (const double x : places) {
    const auto first = static_cast<uint32_t>(soup.positions.size());
    for (const double y : {0.0, 1e-9, 2e-9}) {
      soup.positions.push_back({x, y, 0});
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

TEST(LocalityTest, FacesFollowTheCurveHoweverNearEachOther) {
  // A cell of the grid is 1 / 65536. Backwards, in steps from two cells to a
  // quarter of the box.
  for (const double step : {1.0 / 32768, 1.0 / 4096, 1.0 / 256, 0.25}) {
    std::vector<double> places;
    for (double x = 0.25 * step; x < 1 && places.size() < 100; x += step) {
      places.push_back(x);
    }
    std::ranges::reverse(places);
    std::vector<uint32_t> backwards(places.size());
    std::iota(backwards.rbegin(), backwards.rend(), 0u);
    EXPECT_EQ(FacesAlongCurve(TrianglesAt(places)), backwards) << step;
  }
}

TEST(LocalityTest, FacesInOneCellKeepTheirOrder) {
  // More than the few that sorting leaves in order by chance.
  std::vector<uint32_t> in_order(1000);
  std::iota(in_order.begin(), in_order.end(), 0u);
  EXPECT_EQ(FacesAlongCurve(TrianglesAt(std::vector<double>(1000, 0.3))),
            in_order);
}

TEST(LocalityTest, AMeshWithoutExtentIsNoException) {
  const TriangleSoup soup{{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}},
                          {{0, 1, 2}, {2, 1, 0}}};
  EXPECT_EQ(FacesAlongCurve(soup), (std::vector<uint32_t>{0, 1}));
}

}  // namespace
}  // namespace geodesic
