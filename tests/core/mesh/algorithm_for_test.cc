// Where Chen and Han's rule does not hold, the MMP rule takes its place.

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "geodesic/solve.h"
#include "geodesic/valid_query.h"
#include "tests/support/planar_meshes.h"
#include "tests/support/queries.h"

namespace geodesic {
namespace {

const Source kInFace{FacePoint{3, {0.2, 0.3, 0.5}}};
const Source kAtVertex{VertexPoint{1}};

std::shared_ptr<const Mesh> Grid() {
  return *Mesh::Build(test::MakeGrid({.columns = 4, .rows = 4}));
}

// The algorithm that runs for a query.
Algorithm AlgorithmFor(const Query& query, const Mesh& mesh) {
  return test::Valid(mesh, query)->algorithm;
}

TEST(AlgorithmForTest, ListsGiveWayToTheMmpRuleToo) {
  const auto mesh = Grid();
  const auto runs = [&](const std::vector<Source>& sources) {
    return AlgorithmFor({.sources = sources, .algorithm = Algorithm::kFwpList},
                        *mesh);
  };
  EXPECT_EQ(runs({kInFace}), Algorithm::kFwpList);
  EXPECT_EQ(runs({kAtVertex, kInFace}), Algorithm::kFwpMmp);
}

TEST(AlgorithmForTest, ChenHanRunsFromVerticesAndFromOnePoint) {
  const auto mesh = Grid();
  for (const auto& sources : {std::vector<Source>{kAtVertex},
                              {kAtVertex, {VertexPoint{7}}},
                              {kInFace}}) {
    EXPECT_EQ(AlgorithmFor({.sources = sources, .algorithm = Algorithm::kFwpCh},
                           *mesh),
              Algorithm::kFwpCh);
  }
  // A corner of a face is a vertex, however it is named.
  EXPECT_EQ(AlgorithmFor({.sources = {kAtVertex, {FacePoint{2, {0, 1, 0}}}},
                          .algorithm = Algorithm::kCh},
                         *mesh),
            Algorithm::kCh);
}

TEST(AlgorithmForTest, TrimmingTakesItsPlaceWhereRaysMayPassASource) {
  const auto mesh = Grid();
  EXPECT_EQ(AlgorithmFor({.sources = {kInFace, kAtVertex}}, *mesh),
            Algorithm::kFwpMmp);
  EXPECT_EQ(
      AlgorithmFor({.sources = {{Curve{{VertexPoint{0}, VertexPoint{1}}}}},
                    .algorithm = Algorithm::kIch},
                   *mesh),
      Algorithm::kMmp);
  EXPECT_EQ(
      AlgorithmFor({.sources = {kInFace}, .algorithm = Algorithm::kCh}, *mesh),
      Algorithm::kMmp);
  NoCheckpoint checkpoint;
  const auto field =
      Solve(*mesh, {.sources = {kInFace, kAtVertex}}, {}, checkpoint);
  ASSERT_TRUE(field.ok());
  EXPECT_EQ(field->algorithm, Algorithm::kFwpMmp);
}

TEST(AlgorithmForTest, TrimmingTakesItsPlaceWhereThreeFacesMeet) {
  const auto book = *Mesh::Build(
      {.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}},
       .triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}});
  for (const AlgorithmInfo& info : kAlgorithms) {
    EXPECT_EQ(AlgorithmFor(
                  {.sources = {kAtVertex}, .algorithm = info.algorithm}, *book),
              WithTrimming(info.algorithm));
  }
}

TEST(AlgorithmForTest, TrimmingTakesItsPlaceWhereFacesHaveNoArea) {
  const auto folded =
      *Mesh::Build({.positions = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                    .triangles = {{0, 2, 1}, {0, 1, 3}}});
  EXPECT_TRUE(folded->HasCollapsedFaces());
  EXPECT_FALSE(Grid()->HasCollapsedFaces());
  EXPECT_EQ(AlgorithmFor({.sources = {kAtVertex}}, *folded),
            Algorithm::kFwpMmp);
}

}  // namespace
}  // namespace geodesic
