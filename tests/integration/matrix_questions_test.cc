// Distance matrices and nearest members, by library and by command.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "tests/integration/planar_grid_test.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class MatrixQuestionsTest : public PlanarGridTest {};

TEST_F(MatrixQuestionsTest, MatrixIsDistancesRowByRow) {
  const std::vector<Source> sources = {
      {VertexPoint{3}}, {FacePoint{7, {0.5, 0.25, 0.25}}}, {VertexPoint{3}, 1}};
  const std::vector<Point> from = {
      At(3), Where(FacePoint{7, {0.5, 0.25, 0.25}}), At(3)};
  for (const bool all_vertices : {true, false}) {
    MatrixQuery query = {.mesh_digest = digest_, .sources = sources};
    if (!all_vertices) query.targets = places_;
    MatrixShape shape;
    uint64_t next = 0;
    absl::StatusOr<AnswerInfo> info = client_.ComputeMatrix(
        query, {.on_shape =
                    [&](const MatrixShape& announced) {
                      shape = announced;
                      return absl::OkStatus();
                    },
                .on_row =
                    [&](const MatrixRow& row) {
                      EXPECT_EQ(row.row, next++);
                      EXPECT_TRUE(row.columns.empty());
                      EXPECT_EQ(row.values.size(), shape.columns);
                      for (size_t c = 0; c < row.values.size(); ++c) {
                        const Point to =
                            all_vertices ? At(c) : Where(places_[c]);
                        EXPECT_NEAR(
                            row.values[c],
                            sources[row.row].offset + Euclid(from[row.row], to),
                            kTolerance);
                      }
                      return absl::OkStatus();
                    }});
    ASSERT_TRUE(info.ok()) << info.status();
    EXPECT_EQ(next, sources.size());
    EXPECT_EQ(shape.rows, sources.size());
    EXPECT_EQ(shape.columns, all_vertices ? vertex_count_ : places_.size());
    EXPECT_EQ(info->mesh_digest, digest_);
  }
}

TEST_F(MatrixQuestionsTest, SparseMatrixHoldsWhatIsNear) {
  constexpr double kRadius = 0.3;
  MatrixQuery query = {
      .mesh_digest = digest_, .radius = kRadius, .sparse = true};
  for (uint64_t v = 0; v < vertex_count_; ++v) {
    query.sources.push_back({VertexPoint{v}});
  }
  absl::StatusOr<AnswerInfo> info = client_.ComputeMatrix(
      query, {.on_row = [&](const MatrixRow& row) {
        std::vector<uint32_t> expected;
        for (uint64_t v = 0; v < vertex_count_; ++v) {
          if (Euclid(At(row.row), At(v)) <= kRadius * (1 - 1e-9)) {
            expected.push_back(static_cast<uint32_t>(v));
          }
        }
        // Those at the radius itself may be in or not, by rounding.
        for (size_t i = 0; i < row.columns.size(); ++i) {
          EXPECT_NEAR(row.values[i], Euclid(At(row.row), At(row.columns[i])),
                      kTolerance);
          EXPECT_LE(row.values[i], kRadius);
        }
        EXPECT_TRUE(std::ranges::is_sorted(row.columns));
        EXPECT_TRUE(std::ranges::includes(row.columns, expected));
        return absl::OkStatus();
      }});
  ASSERT_TRUE(info.ok()) << info.status();
}

TEST_F(MatrixQuestionsTest, ReceiverMayEndTheMatrix) {
  MatrixQuery query = {.mesh_digest = digest_};
  query.sources.assign(50, {VertexPoint{1}});
  uint64_t rows = 0;
  const absl::Status status =
      client_
          .ComputeMatrix(query, {.on_row =
                                     [&](const MatrixRow&) {
                                       return ++rows == 3
                                                  ? absl::DataLossError("full")
                                                  : absl::OkStatus();
                                     }})
          .status();
  EXPECT_EQ(status, absl::DataLossError("full"));
  EXPECT_EQ(rows, 3);
}

TEST_F(MatrixQuestionsTest, NearestAreThoseOfBruteForce) {
  std::vector<SurfacePoint> targets = places_;
  for (uint64_t v = 0; v < vertex_count_; v += 5) {
    targets.push_back(VertexPoint{v});
  }
  const std::vector<Source> sources = {{VertexPoint{0}},
                                       {EdgePoint{50, 51, 0.3}}};
  constexpr size_t kCount = 6;
  absl::StatusOr<NearestAnswer> answer =
      client_.FindNearest({.mesh_digest = digest_,
                           .sources = sources,
                           .targets = targets,
                           .count = kCount});
  ASSERT_TRUE(answer.ok()) << answer.status();
  ASSERT_EQ(answer->found.size(), sources.size());
  const std::vector<Point> from = {At(0), Where(EdgePoint{50, 51, 0.3})};
  for (size_t s = 0; s < sources.size(); ++s) {
    std::vector<double> expected;
    for (const SurfacePoint& target : targets) {
      expected.push_back(Euclid(from[s], Where(target)));
    }
    std::ranges::sort(expected);
    ASSERT_EQ(answer->found[s].size(), kCount);
    for (size_t rank = 0; rank < kCount; ++rank) {
      const NearestTarget& found = answer->found[s][rank];
      EXPECT_NEAR(found.distance, expected[rank], kTolerance);
      EXPECT_NEAR(found.distance,
                  Euclid(from[s], Where(targets.at(found.target))), kTolerance);
    }
  }
}

TEST_F(MatrixQuestionsTest, MatrixGoesToFiles) {
  const json answer =
      GeodesicJson({"matrix", grid_, "-s", "0", "-s", "80", "-o",
                    folder_ / "m.npy", "-o", folder_ / "m.csv"});
  EXPECT_EQ(answer["rows"], 2);
  EXPECT_EQ(answer["columns"], vertex_count_);
  const std::string npy = FileBytes(folder_ / "m.npy");
  ASSERT_EQ(npy.size(), 128 + 2 * vertex_count_ * sizeof(double));
  EXPECT_THAT(npy, HasSubstr("'shape': (2, 81), }"));
  for (size_t i = 0; i < 2 * vertex_count_; ++i) {
    double value;
    std::memcpy(&value, npy.data() + 128 + i * sizeof(value), sizeof(value));
    EXPECT_NEAR(value,
                Euclid(At(i < vertex_count_ ? 0 : 80), At(i % vertex_count_)),
                kTolerance);
  }
  EXPECT_EQ(Rows(FileBytes(folder_ / "m.csv")).size(), 2 * vertex_count_);
}

TEST_F(MatrixQuestionsTest, MatrixIsSparseWithinARadius) {
  const json answer =
      GeodesicJson({"matrix", grid_, "-s", "0", "-s", "40", "-r", "0.2",
                    "--float32", "-o", folder_ / "m.npz"});
  uint64_t expected = 0;
  for (const size_t source : {0, 40}) {
    for (size_t v = 0; v < vertex_count_; ++v) {
      expected += Euclid(At(source), At(v)) <= 0.2 ? 1 : 0;
    }
  }
  EXPECT_EQ(answer["finite_values"], expected);
  const std::string npz = FileBytes(folder_ / "m.npz");
  for (const char* member :
       {"data.npy", "indices.npy", "indptr.npy", "shape.npy", "format.npy"}) {
    EXPECT_THAT(npz, HasSubstr(member));
  }
  const ProcessResult text =
      Geodesic({"matrix", grid_, "-s", "0", "-r", "0.2"});
  EXPECT_THAT(text.out, StartsWith("source,target,distance\n0,0,0\n"));
}

TEST_F(MatrixQuestionsTest, TextNamesPlacesAsNearestAndPathDo) {
  const ProcessResult result =
      Geodesic({"matrix", grid_, "-s", "9:2", "-s", "face:7@0.5,0.25,0.25",
                "-t", "9", "-t", "edge:0-1@0.5"});
  EXPECT_THAT(result.out, StartsWith("source,target,distance\n9:2,9,2\n"
                                     "9:2,edge:0-1@0.5,"));
  EXPECT_THAT(result.out, HasSubstr("\n\"face:7@0.5,0.25,0.25\",9,"));
}

TEST_F(MatrixQuestionsTest, NearestAreListed) {
  const json answer = GeodesicJson(
      {"nearest", grid_, "-s", "0", "-t", "80", "-t", "3", "-t", "9", "-k", "2",
       "-o", folder_ / "n.csv", "-o", folder_ / "n.json"});
  const json& found = answer["found"][0]["nearest"];
  ASSERT_EQ(found.size(), 2);
  EXPECT_EQ(found[0]["target"], 2);
  EXPECT_EQ(found[0]["point"]["vertex"], 9);
  EXPECT_NEAR(found[0]["distance"], 1.0 / kGrid, kTolerance);
  EXPECT_EQ(found[1]["point"]["vertex"], 3);
  EXPECT_EQ(json::parse(FileBytes(folder_ / "n.json")), answer["found"]);
  EXPECT_THAT(FileBytes(folder_ / "n.csv"),
              StartsWith("source,rank,target,point,distance\n0,1,2,9,"));
}

}  // namespace
}  // namespace geodesic::client
