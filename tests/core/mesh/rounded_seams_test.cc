// Seams whose places differ by rounding, and what only looks like it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "geodesic/join_seams.h"
#include "geodesic/mesh.h"
#include "geodesic/mesh_summary.h"
#include "tests/support/polyhedra.h"
#include "tests/support/random.h"

namespace geodesic {
namespace {

MeshSummary SummaryOf(TriangleSoup soup, const Welding& welding = {}) {
  const absl::Status status = JoinSeams(welding, soup);
  EXPECT_TRUE(status.ok()) << status;
  const auto mesh = Mesh::Build(std::move(soup));
  EXPECT_TRUE(mesh.ok()) << mesh.status();
  return Summarize(**mesh);
}

// A sphere by meridians and circles of latitude, with two triangles in each
// field, also at the poles: one pole has the radius sin 0, the other sin pi.
template <typename Number>
TriangleSoup GlobeOfFields(int around, int rows, bool has_copies) {
  TriangleSoup soup;
  const auto pi = static_cast<Number>(std::numbers::pi);
  const int columns = has_copies ? around + 1 : around;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Number theta = pi * static_cast<Number>(row) / rows;
      const Number phi = 2 * pi * static_cast<Number>(column) / around;
      soup.positions.push_back({std::sin(theta) * std::cos(phi),
                                std::sin(theta) * std::sin(phi),
                                std::cos(theta)});
    }
  }
  const auto at = [&](int row, int column) {
    return static_cast<uint32_t>(row * columns + column % columns);
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < around; ++column) {
      const uint32_t a = at(row, column), b = at(row + 1, column),
                     c = at(row + 1, column + 1), d = at(row, column + 1);
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  }
  return soup;
}

template <typename Number>
void ExpectClosedGlobes() {
  for (const bool has_copies : {false, true}) {
    const MeshSummary globe =
        SummaryOf(GlobeOfFields<Number>(16, 8, has_copies));
    EXPECT_EQ(globe.boundary_edges, 0);
    EXPECT_EQ(globe.genus, 0);
    EXPECT_EQ(globe.left_out_faces, 32) << "at both poles";
  }
}

TEST(RoundedSeams, APoleIsAPoint) {
  ExpectClosedGlobes<double>();
  ExpectClosedGlobes<float>();
}

// A face that is small all around, and a needle, stay.
TEST(RoundedSeams, SmallFacesStay) {
  const TriangleSoup small = {.positions = {{0, 0, 0},
                                            {1, 0, 0},
                                            {0, 1, 0},
                                            {0, 0, 1},
                                            {1e-9, 0, 1},
                                            {0, 1e-9, 1}},
                              .triangles = {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(SummaryOf(small).joined_vertices, 0);
  const TriangleSoup needle = {
      .positions = {{0, 0, 0}, {1, 0, 0}, {1, 1e-9, 0}},
      .triangles = {{0, 1, 2}}};
  EXPECT_EQ(SummaryOf(needle).joined_vertices, 0);
}

// Two sheets a unit apart, far from the origin along the other axis: numbers of
// millions do not round those of tens.
TEST(RoundedSeams, OneAxisDoesNotRoundAnother) {
  for (const double far : {4e6, 9e6, 2e7, 1e9}) {
    const TriangleSoup sheets = {.positions = {{far, 0, 0},
                                               {far + 100, 0, 0},
                                               {far + 50, 80, 0},
                                               {far, -1, 0},
                                               {far + 100, -1, 0},
                                               {far + 50, -80, 0}},
                                 .triangles = {{0, 1, 2}, {3, 5, 4}}};
    const MeshSummary summary = SummaryOf(sheets);
    EXPECT_EQ(summary.seam_edges, 0) << far;
    EXPECT_EQ(summary.close_edges, 2) << far;
  }
}

// Every corner a vertex of its own, off by up to a unit in the last place of
// the largest coordinate: what is not joined by itself is told, with a distance
// that joins it.
TEST(RoundedSeams, TheDistanceThatIsToldJoins) {
  constexpr double kFar = 3e6;
  const double ulp = std::nextafter(kFar, 1e9) - kFar;
  const TriangleSoup cube = test::Triangulate(test::Box(2000, 2000, 2000));
  for (uint64_t seed = 0; seed < 200; ++seed) {
    test::Random random(seed);
    TriangleSoup soup;
    for (const Triangle& corners : cube.triangles) {
      const auto next = static_cast<uint32_t>(soup.positions.size());
      for (const uint32_t v : corners) {
        Point place = cube.positions[v];
        place[0] += kFar;
        for (double& x : place) {
          x += ulp * (static_cast<double>(random.Below(3)) - 1);
        }
        soup.positions.push_back(place);
      }
      soup.triangles.push_back({next, next + 1, next + 2});
    }
    const MeshSummary by_itself = SummaryOf(soup);
    if (by_itself.boundary_edges == 0) continue;
    ASSERT_GT(by_itself.close_edges, 0) << seed;
    const MeshSummary welded =
        SummaryOf(soup, {.kind = Welding::Kind::kWithin,
                         .distance = by_itself.close_edge_distance});
    EXPECT_EQ(welded.close_edges, 0) << seed;
    EXPECT_LT(welded.boundary_edges, by_itself.boundary_edges) << seed;
  }
}

}  // namespace
}  // namespace geodesic
