#include "geodesic/query.h"

#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "tests/support/planar_meshes.h"

namespace geodesic {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Ten vertices in two rows of five, eight faces.
std::shared_ptr<const Mesh> Strip() {
  return *Mesh::Build(test::MakeGrid({.columns = 4, .rows = 1}));
}

std::string RefusalOf(const Query& query) {
  const absl::Status status = Validate(query, *Strip());
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << status;
  return std::string(status.message());
}

std::string RefusalOf(const SurfacePoint& point) {
  return RefusalOf(Query{.sources = {{VertexPoint{0}}, {point}}});
}

TEST(QueryTest, RefusalsNameTheSource) {
  EXPECT_THAT(RefusalOf(Query{}), HasSubstr("sources is empty"));
  EXPECT_THAT(RefusalOf(VertexPoint{10}),
              HasSubstr("sources[1].vertex 10 is out of range"));
  for (double offset : {-1.0, kInfinity, kNan}) {
    EXPECT_THAT(RefusalOf(Query{.sources = {{VertexPoint{3}, offset}}}),
                HasSubstr("sources[0].offset"));
  }
  EXPECT_THAT(RefusalOf(Query{.sources = {{VertexPoint{0}}},
                              .algorithm = Algorithm(99)}),
              HasSubstr("algorithm"));
}

// The strip is 4 long. Far larger offsets leave no digits for its distances.
TEST(QueryTest, OffsetsAreBoundedByTheSizeOfTheMesh) {
  EXPECT_EQ(Validate(Query{.sources = {{VertexPoint{3}, 1e6}}}, *Strip()),
            absl::OkStatus());
  for (double offset : {1e7, 2e272}) {
    EXPECT_THAT(RefusalOf(Query{.sources = {{VertexPoint{3}, offset}}}),
                HasSubstr("size of the mesh"));
  }
}

TEST(QueryTest, RefusalsNamePointsOffTheSurface) {
  EXPECT_THAT(RefusalOf(EdgePoint{0, 10, 0.5}), HasSubstr("edge.to 10"));
  EXPECT_THAT(RefusalOf(EdgePoint{0, 4, 0.5}),
              HasSubstr("no edge between vertices 0 and 4"));
  for (double t : {-0.1, 1.1, kNan}) {
    EXPECT_THAT(RefusalOf(EdgePoint{0, 1, t}), HasSubstr("sources[1].edge.t"));
  }
  EXPECT_THAT(RefusalOf(FacePoint{8, {1, 0, 0}}), HasSubstr("face 8"));
  EXPECT_THAT(RefusalOf(FacePoint{2, {-0.1, 0.6, 0.5}}),
              HasSubstr("outside face 2"));
  EXPECT_THAT(RefusalOf(FacePoint{2, {0, kNan, 0.5}}), HasSubstr("weights[1]"));
  EXPECT_THAT(RefusalOf(FacePoint{2, {0.5, 0.5, 0.5}}),
              HasSubstr("sum to 1.5"));
}

TEST(QueryTest, RefusalsNameCurvesAndTargets) {
  EXPECT_THAT(RefusalOf(Query{.curves = {{}}}),
              HasSubstr("curves[0].points is empty"));
  EXPECT_THAT(RefusalOf(Query{.curves = {{{VertexPoint{0}, VertexPoint{4}}}}}),
              HasSubstr("curves[0].points[0] and [1] lie in no common face"));
  EXPECT_THAT(RefusalOf(Query{.curves = {{{VertexPoint{0}}, kNan}}}),
              HasSubstr("curves[0].offset"));
  EXPECT_THAT(RefusalOf(Query{.sources = {{VertexPoint{0}}},
                              .targets = {VertexPoint{0}, VertexPoint{11}}}),
              HasSubstr("targets[1].vertex 11"));
}

TEST(QueryTest, EveryListedAlgorithmIsValidAndKnownByName) {
  const auto mesh = Strip();
  for (const AlgorithmInfo& info : kAlgorithms) {
    EXPECT_TRUE(Validate(Query{.sources = {{VertexPoint{9}}},
                               .algorithm = info.algorithm},
                         *mesh)
                    .ok());
    EXPECT_EQ(*AlgorithmFromName(info.name), info.algorithm);
    EXPECT_EQ(AlgorithmName(info.algorithm), info.name);
  }
  EXPECT_THAT(std::string(AlgorithmFromName("dijkstra").status().message()),
              HasSubstr("fwp-ch"));
}

TEST(QueryTest, CanonicalFormSortsAndKeepsTheLeastOffset) {
  const auto at = [](uint32_t vertex, double offset) {
    return Source{VertexPoint{vertex}, offset};
  };
  const Query canonical = Canonicalize(
      Query{.sources = {at(5, 2), at(1, -0.0), at(5, 1), at(1, 0), at(3, 0)}},
      *Strip());
  EXPECT_THAT(canonical.sources, ElementsAre(at(1, 0), at(3, 0), at(5, 1)));
  EXPECT_FALSE(std::signbit(canonical.sources[0].offset));
}

TEST(QueryTest, CanonicalPointsLieOnTheLowestElement) {
  const auto mesh = Strip();
  const auto canonical = [&](const SurfacePoint& point) {
    return Canonicalize(point, *mesh);
  };
  const Triangle corners = mesh->triangle(3);
  EXPECT_EQ(canonical(FacePoint{3, {0, 1, 0}}),
            SurfacePoint(VertexPoint{corners[1]}));
  EXPECT_EQ(canonical(EdgePoint{1, 0, 0}), SurfacePoint(VertexPoint{1}));
  EXPECT_EQ(canonical(EdgePoint{1, 0, 1}), SurfacePoint(VertexPoint{0}));
  // 1 - t rounds to 1, or the point cannot be told from the vertex.
  EXPECT_EQ(canonical(EdgePoint{1, 0, 1e-17}), SurfacePoint(VertexPoint{1}));
  EXPECT_EQ(canonical(EdgePoint{0, 1, 1e-200}), SurfacePoint(VertexPoint{0}));
  EXPECT_EQ(canonical(FacePoint{3, {1e-200, 1, 1e-200}}),
            SurfacePoint(VertexPoint{corners[1]}));
  EXPECT_EQ(canonical(EdgePoint{1, 0, 0.25}),
            SurfacePoint(EdgePoint{0, 1, 0.75}));
  const auto on_edge =
      std::get<EdgePoint>(canonical(FacePoint{3, {0.25, 0, 0.75}}));
  EXPECT_EQ(on_edge.t, on_edge.from == corners[0] ? 0.75 : 0.25);
  EXPECT_EQ(canonical(FacePoint{3, {0.25, 0.25, 0.5}}),
            SurfacePoint(FacePoint{3, {0.25, 0.25, 0.5}}));
}

TEST(QueryTest, PositionsAreThoseOfTheWeights) {
  const auto mesh = Strip();
  const auto& p = mesh->positions();
  const Triangle t = mesh->triangle(5);
  const Point at = PositionOf(FacePoint{5, {0.5, 0.25, 0.25}}, *mesh);
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(at[i],
                     0.5 * p[t[0]][i] + 0.25 * p[t[1]][i] + 0.25 * p[t[2]][i]);
  }
}

}  // namespace
}  // namespace geodesic
