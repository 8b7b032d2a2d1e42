#include "client/places/nearest_point.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "client/places/place_finder.h"
#include "tests/support/surface_points.h"

namespace geodesic::client {
namespace {

using ::testing::HasSubstr;

// Of lengths, relative to the size of the scene: a few roundings.
constexpr double kRounding = 1e-14;

// A right triangle in the plane z = 0, its mirror image in y = 0, and a vertex
// of no face.
const MeshArrays kWings = {
    {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, -4, 0}, {1, 1, 9}},
    {{0, 1, 2}, {0, 3, 1}}};

// How far a point of the mesh is away.
double Distance(const SurfacePoint& point, const MeshArrays& mesh,
                const Point& to) {
  return static_cast<double>(test::Norm(
      test::PositionIn(
          {.positions = mesh.positions, .triangles = mesh.triangles}, point) -
      test::ToVec3(to)));
}

TEST(NearestPointTest, IsInAFaceOnAnEdgeOrAVertex) {
  const auto nearest = [](const Point& to) {
    return *FindOnMesh(kWings, NearestPoint{to});
  };
  // Above the face, with weights 1/4, 1/4, 1/2.
  const auto face = std::get<FacePoint>(nearest({1, 2, 7}));
  EXPECT_EQ(face.face, 0);
  EXPECT_NEAR(face.weights[0], 0.25, kRounding);
  EXPECT_NEAR(face.weights[1], 0.25, kRounding);
  EXPECT_NEAR(face.weights[2], 0.5, kRounding);
  EXPECT_EQ(nearest({3, 0, -1}), SurfacePoint(EdgePoint{0, 1, 0.75}));
  EXPECT_EQ(nearest({5, 5, 1}), SurfacePoint(EdgePoint{1, 2, 0.5}));
  EXPECT_EQ(nearest({-1, 1, 0}), SurfacePoint(EdgePoint{2, 0, 0.75}));
  EXPECT_EQ(nearest({-1, 0, 3}), SurfacePoint(VertexPoint{0}));
  EXPECT_EQ(nearest({9, -1, 0}), SurfacePoint(VertexPoint{1}));
  EXPECT_EQ(nearest({0, -4, 0}), SurfacePoint(VertexPoint{3}));
  // The vertex of no face is no part of the surface.
  EXPECT_TRUE(std::holds_alternative<FacePoint>(nearest({1, 1, 9})));
}

// No point of a fine sampling of all faces is nearer, and the point that was
// found is a valid one.
TEST(NearestPointTest, NoOtherPointIsNearer) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&] {
    return Point{coordinate(random), coordinate(random), coordinate(random)};
  };
  for (int scene = 0; scene < 200; ++scene) {
    MeshArrays mesh;
    for (uint32_t face = 0; face < 5; ++face) {
      for (int i = 0; i < 3; ++i) mesh.positions.push_back(point());
      mesh.triangles.push_back({3 * face, 3 * face + 1, 3 * face + 2});
    }
    // Faces without area, and a sliver.
    mesh.positions[1] = mesh.positions[0];
    for (size_t i = 3; i < 6; ++i) mesh.positions[i] = mesh.positions[3];
    mesh.positions[8] = mesh.positions[7];
    mesh.positions[8][0] += 1e-13;
    const Point to = point();
    const auto found = FindOnMesh(mesh, NearestPoint{to});
    ASSERT_TRUE(found.ok()) << found.status();
    if (const auto* in_face = std::get_if<FacePoint>(&*found)) {
      const auto& w = in_face->weights;
      EXPECT_GT(*std::ranges::min_element(w), 0);
      EXPECT_NEAR(w[0] + w[1] + w[2], 1, kRounding);
    } else if (const auto* on_edge = std::get_if<EdgePoint>(&*found)) {
      EXPECT_GT(on_edge->t, 0);
      EXPECT_LT(on_edge->t, 1);
    }
    const double distance = Distance(*found, mesh, to);
    constexpr int kSteps = 20;
    for (uint32_t face = 0; face < mesh.triangles.size(); ++face) {
      for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; i + j <= kSteps; ++j) {
          const FacePoint sample{face,
                                 {i / double{kSteps}, j / double{kSteps},
                                  (kSteps - i - j) / double{kSteps}}};
          EXPECT_GE(Distance(sample, mesh, to), distance - kRounding) << scene;
        }
      }
    }
  }
}

TEST(NearestPointTest, TheUnitDoesNotMatter) {
  for (const double unit : {0x1p-1000, 0x1p-500, 1.0, 0x1p500, 0x1p1000}) {
    MeshArrays mesh = kWings;
    for (Point& position : mesh.positions) {
      for (double& x : position) x *= unit;
    }
    EXPECT_EQ(*FindOnMesh(mesh, NearestPoint{{unit, 2 * unit, 7 * unit}}),
              *FindOnMesh(kWings, NearestPoint{{1, 2, 7}}))
        << unit;
  }
  // Far from all.
  EXPECT_EQ(*FindOnMesh(kWings, NearestPoint{{1e9, 1, 0}}),
            SurfacePoint(VertexPoint{1}));
  EXPECT_TRUE(
      FindOnMesh(kWings,
                 NearestPoint{{std::numeric_limits<double>::max(), 0, 0}})
          .ok());
}

TEST(ExtremeVertexTest, TheFirstOfSeveralOnTheSurface) {
  const auto find = [](size_t axis, bool is_greatest) {
    return *FindOnMesh(kWings, ExtremeVertex{axis, is_greatest});
  };
  EXPECT_EQ(find(0, false), SurfacePoint(VertexPoint{0}));
  EXPECT_EQ(find(0, true), SurfacePoint(VertexPoint{1}));
  EXPECT_EQ(find(1, false), SurfacePoint(VertexPoint{3}));
  EXPECT_EQ(find(1, true), SurfacePoint(VertexPoint{2}));
  EXPECT_EQ(find(2, false), SurfacePoint(VertexPoint{0}));
  // The highest vertex is of no face, so nothing could be measured from it.
  EXPECT_EQ(find(2, true), SurfacePoint(VertexPoint{0}));
}

TEST(ExtremeVertexTest, LeftOutFacesDoNotCount) {
  // The last two faces name a vertex twice, the second once 5 is joined into 4.
  const MeshArrays mesh = {
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}, {8, 8, 8}, {8, 8, 8}},
      {{0, 1, 2}, {3, 3, 0}, {4, 5, 0}},
      {{5, 4}}};
  EXPECT_EQ(*FindOnMesh(mesh, ExtremeVertex{0, true}),
            SurfacePoint(VertexPoint{1}));
  EXPECT_EQ(*FindOnMesh(mesh, NearestPoint{{9, 0, 0}}),
            SurfacePoint(VertexPoint{1}));
}

TEST(FindOnMeshTest, NamesWhatTheMeshLacks) {
  const MeshArrays points = {{{0, 0, 0}}, {}};
  const absl::Status no_faces =
      FindOnMesh(points, NearestPoint{{1, 2, 3}}).status();
  EXPECT_TRUE(absl::IsInvalidArgument(no_faces));
  EXPECT_THAT(std::string(no_faces.message()), HasSubstr("has no faces"));
  const absl::Status no_surface =
      FindOnMesh(points, ExtremeVertex{0, true}).status();
  EXPECT_TRUE(absl::IsInvalidArgument(no_surface));
  EXPECT_THAT(std::string(no_surface.message()), HasSubstr("has no faces"));
}

TEST(PlaceFinderTest, ReadsTheMeshOnceAndOnlyIfItMust) {
  int reads = 0;
  PlaceFinder finder([&reads]() -> absl::StatusOr<MeshArrays> {
    ++reads;
    return kWings;
  });
  EXPECT_EQ(*finder.Find(WrittenPoint(VertexPoint{9})),
            SurfacePoint(VertexPoint{9}));
  EXPECT_EQ(reads, 0);
  EXPECT_EQ(*finder.Find(
                WrittenPair{ExtremeVertex{0, true}, NearestPoint{{0, 9, 0}}}),
            (PointPair{VertexPoint{1}, VertexPoint{2}}));
  EXPECT_EQ(*finder.Find(WrittenSource{
                {VertexPoint{1}, NearestPoint{{2, 2, 0}}}, true, 0.5}),
            (Source{Curve{{VertexPoint{1}, EdgePoint{1, 2, 0.5}}}, 0.5}));
  EXPECT_EQ(reads, 1);

  PlaceFinder broken([]() -> absl::StatusOr<MeshArrays> {
    return absl::UnavailableError("gone");
  });
  EXPECT_EQ(broken.Find(WrittenPoint(ExtremeVertex{})).status(),
            absl::UnavailableError("gone"));
}

}  // namespace
}  // namespace geodesic::client
