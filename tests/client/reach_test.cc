// Why no path leads somewhere.

#include "client/places/reach.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace geodesic::client {
namespace {

using ::testing::HasSubstr;

// Triangles side by side along the x axis, each with vertices of its own but
// the last two, which share vertex 6; vertex 11 is on no face.
MeshArrays Triangles() {
  return {{{0, 0, 0},
           {1, 0, 0},
           {0, 1, 0},
           {1, 0, 0},
           {2, 0, 0},
           {2, 1, 0},
           {7, 0, 0},
           {8, 0, 0},
           {8, 1, 0},
           {6, 0, 0},
           {6, 1, 0},
           {9, 9, 9}},
          {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {6, 9, 10}}};
}

std::string Why(const std::vector<Source>& sources, const SurfacePoint& to) {
  const MeshArrays mesh = Triangles();
  return Reach(mesh, sources).WhyUnreached(to, "of a limit");
}

TEST(ReachTest, SaysWhy) {
  const std::vector<Source> from_0 = {{VertexPoint{0}}};
  EXPECT_EQ(Why(from_0, VertexPoint{11}), "vertex 11 is on no face");
  EXPECT_EQ(Why({{VertexPoint{11}}}, VertexPoint{0}),
            "vertex 11, the source, is on no face");
  EXPECT_EQ(Why(from_0, EdgePoint{1, 2, 0.5}), "of a limit");
  EXPECT_EQ(Why({{VertexPoint{11}}, {VertexPoint{9}}}, VertexPoint{8}),
            "of a limit");
  EXPECT_EQ(Why(from_0, FacePoint{2, {1, 0, 0}}),
            "it lies in another component of the mesh");
  // Vertex 3 lies where 1 does.
  EXPECT_EQ(Why({{Curve{{VertexPoint{0}, VertexPoint{2}}}}}, VertexPoint{5}),
            "it lies in another component of the mesh; it touches others at 1 "
            "point, where vertices lie twice (3 and 1, say): merge them to let "
            "paths pass");
}

// Vertex 3 was joined into 1, and 5 into 4, which only faces name that are left
// out, one of them as it was joined.
TEST(ReachTest, LeftOutFacesHoldNothing) {
  const MeshArrays mesh = {
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {5, 5, 5}, {5, 5, 5}},
      {{0, 3, 2}, {4, 4, 0}, {4, 5, 2}},
      {{3, 1}, {5, 4}}};
  Reach reach(mesh, std::vector<Source>{{VertexPoint{0}}});
  for (const uint32_t vertex : {0, 1, 2, 3}) {
    EXPECT_FALSE(reach.IsIsolated(vertex)) << vertex;
    EXPECT_EQ(reach.WhyUnreached(VertexPoint{vertex}, "of a limit"),
              "of a limit");
  }
  for (const uint64_t vertex : {4, 5}) {
    EXPECT_TRUE(reach.IsIsolated(vertex)) << vertex;
  }
}

TEST(ReachTest, PlacesThatTheMeshDoesNotHaveDoNoHarm) {
  EXPECT_EQ(Why({{VertexPoint{99}}}, FacePoint{99, {1, 0, 0}}), "of a limit");
  const MeshArrays mesh = Triangles();
  EXPECT_FALSE(Reach(mesh, {}).IsIsolated(99));
}

}  // namespace
}  // namespace geodesic::client
