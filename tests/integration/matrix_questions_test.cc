// Distance matrices and nearest members, by library and by command.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "tests/integration/planar_grid_test.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class MatrixQuestionsTest : public PlanarGridTest {};

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
