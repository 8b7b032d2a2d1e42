// Seams whose places differ by rounding, and what only looks like it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "geodesic/join_seams.h"
#include "geodesic/mesh.h"
#include "geodesic/mesh_summary.h"
#include "tests/support/meshes/polyhedra.h"
#include "tests/support/random.h"

namespace geodesic {
namespace {

TriangleSoup Joined(TriangleSoup soup, const Welding& welding = {}) {
  const absl::Status status = JoinSeams(welding, soup);
  EXPECT_TRUE(status.ok()) << status;
  return soup;
}

MeshSummary SummaryOf(TriangleSoup soup, const Welding& welding = {}) {
  const auto mesh = Mesh::Build(Joined(std::move(soup), welding));
  EXPECT_TRUE(mesh.ok()) << mesh.status();
  return Summarize(**mesh);
}

struct GlobeKind {
  // Whether the last meridian repeats the first, as for textures: its places
  // are computed anew, so they differ by rounding.
  bool has_copies = false;
  // Whether fields have two triangles at the poles, too.
  bool has_polar_faces = false;
};
constexpr GlobeKind kSlit = {.has_copies = true};

// A sphere by meridians and circles of latitude: one pole has the radius sin 0,
// the other sin pi.
template <typename Number>
TriangleSoup Globe(int around, int rows, const GlobeKind& kind) {
  TriangleSoup soup;
  const auto pi = static_cast<Number>(std::numbers::pi);
  const int columns = kind.has_copies ? around + 1 : around;
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
      if (kind.has_polar_faces || row + 1 < rows) {
        soup.triangles.push_back({a, b, c});
      }
      if (kind.has_polar_faces || row > 0) soup.triangles.push_back({a, c, d});
    }
  }
  return soup;
}

TEST(RoundedSeams, ASlitWhoseSidesWereComputedTwiceIsClosed) {
  for (const bool is_single : {false, true}) {
    TriangleSoup soup =
        is_single ? Globe<float>(24, 12, kSlit) : Globe<double>(24, 12, kSlit);
    EXPECT_NE(soup.positions[25 + 24], soup.positions[25]);
    // Ten edges between eleven rows, and two at the poles, where each column
    // has a vertex: those meet along their edges.
    const MeshSummary summary = SummaryOf(std::move(soup));
    EXPECT_EQ(summary.boundary_edges, 0u) << is_single;
    EXPECT_EQ(summary.genus, 0) << is_single;
    EXPECT_EQ(summary.close_edges, 0u) << is_single;
  }
}

TEST(RoundedSeams, ASlitIsClosedWhateverDigitsAreWritten) {
  for (const char* const format :
       {"%.4f", "%.6f", "%g", "%.9g", "%.12f", "%.17g"}) {
    TriangleSoup soup = Globe<float>(24, 12, kSlit);
    for (Point& p : soup.positions) {
      for (double& x : p) {
        char text[64];
        // Away from 0, so that digits are rounded apart.
        const auto moved = static_cast<float>(x) * 12.3456789f + 0.7654321f;
        std::snprintf(text, sizeof(text), format, static_cast<double>(moved));
        x = std::stod(text);
      }
    }
    EXPECT_EQ(SummaryOf(std::move(soup)).boundary_edges, 0u) << format;
  }
}

// What somebody has chosen is no rounding, however few its digits.
TEST(RoundedSeams, ChosenGapsStayOpen) {
  for (const double gap : {0.2, 0.1, 0.01, 1e-3, 1e-5, 1e-9, 4e-9}) {
    const std::vector<Point> two = {{0, 0, 0},   {1, 0, 0},   {0, 1, 0},
                                    {0, 0, gap}, {1, 0, gap}, {0, 1, gap}};
    const TriangleSoup sheets = {.positions = two,
                                 .triangles = {{0, 1, 2}, {3, 4, 5}}};
    EXPECT_TRUE(Joined(sheets).reading.is_plain()) << gap;
    // A slit from the middle of a square's side to near the other one.
    const std::vector<Point> around = {
        {0, 0, 0}, {10, 0, 0},       {10, 10, 0}, {5 + gap, 10, 0},
        {5, 1, 0}, {5 - gap, 10, 0}, {0, 10, 0}};
    const TriangleSoup slit = {
        .positions = around,
        .triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {4, 5, 6}, {0, 4, 6}}};
    EXPECT_TRUE(Joined(slit).reading.is_plain()) << gap;
  }
}

TEST(RoundedSeams, VerticesFarOffDoNotRoundOthers) {
  // Two squares, 0.1 apart, and a vertex or a face far off.
  for (const bool is_face : {false, true}) {
    const std::vector<Point> positions = {
        {0, 0, 0},    {1, 0, 0},       {1, 1, 0},      {0, 1, 0},
        {1.1, 0, 0},  {1.1, 1, 0},     {2, 0, 0},      {2, 1, 0},
        {1e16, 0, 0}, {1e16, 1e15, 0}, {1e16, 0, 1e15}};
    TriangleSoup soup{
        .positions = positions,
        .triangles = {{0, 1, 2}, {0, 2, 3}, {4, 6, 7}, {4, 7, 5}}};
    if (is_face) soup.triangles.push_back({8, 9, 10});
    EXPECT_EQ(Joined(soup).reading.seam_edges, 0u) << is_face;
  }
}

template <typename Number>
void ExpectClosedGlobes() {
  for (const bool has_copies : {false, true}) {
    const MeshSummary globe = SummaryOf(Globe<Number>(
        16, 8, {.has_copies = has_copies, .has_polar_faces = true}));
    EXPECT_EQ(globe.boundary_edges, 0);
    EXPECT_EQ(globe.genus, 0);
    EXPECT_EQ(globe.left_out_faces, 32) << "at both poles";
  }
}

TEST(RoundedSeams, APoleIsAPoint) {
  ExpectClosedGlobes<double>();
  ExpectClosedGlobes<float>();
}

// Those that are small all around.
TEST(RoundedSeams, SmallFacesStay) {
  const std::vector<Point> positions = {{0, 0, 0}, {1, 0, 0},    {0, 1, 0},
                                        {0, 0, 1}, {1e-9, 0, 1}, {0, 1e-9, 1}};
  const TriangleSoup small = {.positions = positions,
                              .triangles = {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(SummaryOf(small).joined_vertices, 0);
}

// Two sheets a unit apart, far from the origin along the other axis: numbers of
// millions do not round those of tens.
TEST(RoundedSeams, OneAxisDoesNotRoundAnother) {
  for (const double far : {4e6, 9e6, 2e7, 1e9}) {
    const std::vector<Point> positions = {
        {far, 0, 0},  {far + 100, 0, 0},  {far + 50, 80, 0},
        {far, -1, 0}, {far + 100, -1, 0}, {far + 50, -80, 0}};
    const TriangleSoup sheets = {.positions = positions,
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
