// The log map against closed forms in planes and on cones, and its laws.

#include "geodesic/log_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "absl/status/status.h"
#include "geodesic_types/field_path.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/core/questions/path_check.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/developable_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

class LogMapTest : public EveryAlgorithm {
 protected:
  void Prepare(const NamedMesh& named, const Source& source) {
    mesh_ = BuildOrFail(named);
    const Query query = Ask({.sources = {source}, .trace = true});
    field_ = SolveTraced(*mesh_, query);
    map_ = ComputeLogMap(*mesh_, Valid(*mesh_, query), field_).value();
    ASSERT_EQ(map_.coordinates.size(), mesh_->vertex_count());
    for (uint32_t v = 0; v < mesh_->vertex_count(); ++v) {
      const auto& [x, y] = map_.coordinates[v];
      if (std::isinf(field_.distances[v])) {
        EXPECT_TRUE(std::isnan(x) && std::isnan(y)) << v;
      } else {
        const double distance = field_.distances[v] - source.offset;
        EXPECT_NEAR(std::hypot(x, y), distance, 1e-13 * distance) << v;
      }
    }
  }
  // Coordinates are those of the plane itself, turned so that zero_direction is
  // the x axis.
  void ExpectPlane(const std::vector<Point>& positions, const Vec3& from) {
    const Vec3 zero = ToVec3(map_.zero_direction);
    for (uint32_t v = 0; v < mesh_->vertex_count(); ++v) {
      const Vec3 away = ToVec3(positions[v]) - from;
      EXPECT_NEAR(map_.coordinates[v][0], static_cast<double>(Dot(zero, away)),
                  1e-12)
          << v;
      EXPECT_NEAR(map_.coordinates[v][1],
                  static_cast<double>(Cross(zero, away).z), 1e-12)
          << v;
    }
  }
  double Angle(uint32_t v) const {
    return std::atan2(map_.coordinates[v][1], map_.coordinates[v][0]);
  }

  std::shared_ptr<const Mesh> mesh_;
  DistanceField field_;
  LogMap map_;
};

TEST_P(LogMapTest, IsThePlaneInAPlane) {
  for (const double jitter : {0.0, 0.2}) {
    const TriangleSoup grid =
        MakeGrid({.columns = 12, .rows = 9, .jitter = jitter});
    const Triangle& face = grid.triangles[90];
    // Inside, on an edge within and at the boundary, at vertices likewise.
    for (const SurfacePoint& point : std::vector<SurfacePoint>{
             VertexPoint{50}, VertexPoint{5}, VertexPoint{0},
             EdgePoint{face[0], face[1], 0.3}, EdgePoint{3, 4, 0.75},
             EdgePoint{4, 3, 0.5}, EdgePoint{118, 117, 0.25},
             FacePoint{90, {0.2, 0.3, 0.5}}}) {
      Prepare({"grid", grid}, {point, 2});
      EXPECT_NEAR(static_cast<double>(Norm(ToVec3(map_.zero_direction))), 1,
                  1e-15);
      ExpectPlane(grid.positions, ToVec3(PositionOf(point, *mesh_)));
    }
  }
}

// From the apex of a cone or a saddle fan angles are shares of the full turn,
// from that of an open fan they are what they are.
TEST_P(LogMapTest, ScalesTheAnglesAroundAnApex) {
  constexpr uint32_t kSpokes = 12;
  for (const double total : {2.0, 5.0, 8.0, 14.0}) {
    for (const bool closed : {true, false}) {
      if (!closed && total > std::numbers::pi) continue;
      const Fan fan({.spokes = kSpokes,
                     .rings = 3,
                     .total_angle = total,
                     .closed = closed});
      Prepare({"fan", fan.soup()}, {VertexPoint{0}});
      // Vertices of one ring follow each other around the apex; by their
      // distances from each other, so do their angles.
      const uint32_t per_ring = closed ? kSpokes : kSpokes + 1;
      const double sector = total / kSpokes;
      const double step = closed ? 2 * std::numbers::pi / kSpokes : sector;
      for (uint32_t ring = 0; ring < 3; ++ring) {
        for (uint32_t i = 1; i < per_ring; ++i) {
          const uint32_t v = 1 + ring * per_ring + i;
          const double turn = std::remainder(Angle(v) - Angle(v - 1) - step,
                                             2 * std::numbers::pi);
          EXPECT_NEAR(turn, 0, 1e-12) << total << " " << v;
        }
      }
    }
  }
}

// The ends of an edge that no other shortest path comes between lie beside each
// other: next to the source the map is one piece.
TEST_P(LogMapTest, IsContinuousAroundTheSource) {
  const TriangleSoup soup = Torus({.around = 24, .across = 16, .noise = 0.05});
  for (const uint32_t source : {0u, 77u, 200u}) {
    Prepare({"torus", soup}, {VertexPoint{source}});
    for (const Triangle& triangle : soup.triangles) {
      for (int i = 0; i < 3; ++i) {
        const uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
        constexpr double kNear = 1.0;
        if (field_.distances[a] > kNear || field_.distances[b] > kNear) {
          continue;
        }
        const double length =
            static_cast<double>(Distance(soup.positions[a], soup.positions[b]));
        const double mapped =
            std::hypot(map_.coordinates[a][0] - map_.coordinates[b][0],
                       map_.coordinates[a][1] - map_.coordinates[b][1]);
        EXPECT_LT(mapped, 1.8 * length) << source << ": " << a << "-" << b;
      }
    }
  }
}

// A path along an edge of the source may end at a vertex that an edge without
// length joins to the one it is asked for.
TEST_P(LogMapTest, SeesPastEdgesWithoutLength) {
  const TriangleSoup grid = MakeGrid({.columns = 4, .rows = 4});
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    std::vector<uint32_t> doubled;
    const TriangleSoup soup = DoubleVertices(grid, 3, seed, &doubled);
    for (const uint32_t source : {6u, 7u, 12u}) {
      if (std::ranges::find(doubled, source) != doubled.end()) continue;
      SCOPED_TRACE(testing::Message() << seed << ": from " << source);
      Prepare({"grid with double vertices", soup}, {VertexPoint{source}});
      ExpectPlane(soup.positions, ToVec3(soup.positions[source]));
    }
  }
}

TEST_P(LogMapTest, IsNotANumberInOtherPieces) {
  const TriangleSoup sphere = Icosphere(1);
  Prepare({"two spheres", Join(sphere, sphere)}, {VertexPoint{3}});
  EXPECT_FALSE(std::isnan(map_.coordinates[5][0]));
  EXPECT_TRUE(std::isnan(map_.coordinates[sphere.positions.size()][0]));
}

GEODESIC_TEST_EVERY_ALGORITHM(LogMapTest);

TEST(LogMap, RefusesWhatHasNoDirections) {
  const TriangleSoup sphere = Icosphere(1);
  // Two squares that touch in vertex 0, and a vertex of no face.
  const TriangleSoup touching = {
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {5, 5, 5}},
      {{0, 1, 2}, {0, 3, 4}}};
  const auto status = [](const TriangleSoup& soup, Query query) {
    const auto mesh = BuildOrFail({"mesh", soup});
    query.trace = true;
    return ComputeLogMap(*mesh, Valid(*mesh, query), SolveTraced(*mesh, query))
        .status();
  };
  EXPECT_EQ(status(sphere, {.sources = {{VertexPoint{0}}, {VertexPoint{1}}}}),
            InvalidField("sources",
                         "sources: a log map has exactly one, which "
                         "is a point"));
  EXPECT_EQ(
      FieldPathOf(status(sphere, {.sources = {{Curve{{VertexPoint{0}}}}}})),
      "sources");
  EXPECT_EQ(status(touching, {.sources = {{VertexPoint{0}}}}),
            absl::InvalidArgumentError(
                "source vertex 0: the surface around it is not one oriented "
                "disk or half-disk"));
  EXPECT_EQ(status(touching, {.sources = {{VertexPoint{5}}}}),
            absl::InvalidArgumentError(
                "source vertex 5 belongs to no face, so that no path leaves "
                "it; name a point of a face"));
}

}  // namespace
}  // namespace geodesic::test
