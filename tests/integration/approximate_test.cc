// Approximate algorithms, by library and by command: what they answer, what
// they refuse, and that nobody can take them for exact.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/integration/planar_grid_test.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

// On a square all methods are right but for this part of the distance, or in
// edges' lengths where it is short: fronts around a source are not straight.
constexpr double kPart = 0.06;
constexpr double kShort = 0.3 / kGrid;

class ApproximateTest : public PlanarGridTest {
 protected:
  void ExpectNear(double distance, uint64_t from, uint64_t to) const {
    const double exact = Euclid(At(from), At(to));
    EXPECT_NEAR(distance, exact, kPart * exact + kShort);
  }
};

TEST_F(ApproximateTest, FieldsAreNearAndSaySo) {
  EXPECT_THAT(ApproximateAlgorithmNames(), SizeIs(5));
  for (const std::string& algorithm : ApproximateAlgorithmNames()) {
    SCOPED_TRACE(algorithm);
    const absl::StatusOr<Field> field =
        client_.ComputeField({.mesh_digest = digest_,
                              .sources = {{VertexPoint{0}}},
                              .algorithm = algorithm,
                              .targets = {VertexPoint{kMiddle}}});
    ASSERT_TRUE(field.ok()) << field.status();
    EXPECT_EQ(field->algorithm, algorithm);
    ASSERT_TRUE(field->approximation.has_value());
    EXPECT_EQ(field->relative_tolerance, kInfinity);
    EXPECT_EQ(field->settled_radius, 0);
    for (uint64_t v = 0; v < vertex_count_; ++v) {
      ExpectNear(field->distances[v], 0, v);
    }
    EXPECT_EQ(field->target_distances[0], field->distances[kMiddle]);
  }
  const absl::StatusOr<Field> exact = client_.ComputeField(
      {.mesh_digest = digest_, .sources = {{VertexPoint{0}}}});
  EXPECT_EQ(exact->origin, FieldOrigin::kComputed);
  EXPECT_FALSE(exact->approximation.has_value());
  EXPECT_LT(exact->relative_tolerance, 1e-9);
}

TEST_F(ApproximateTest, ParametersMakeOtherFields) {
  const auto heat = [&](std::optional<double> lambda) {
    return *client_.ComputeField({.mesh_digest = digest_,
                                  .sources = {{VertexPoint{0}}},
                                  .algorithm = "heat",
                                  .approximation = {.lambda = lambda}});
  };
  const Field usual = heat({});
  EXPECT_EQ(usual.approximation->lambda, 1);
  EXPECT_EQ(heat(1).origin, FieldOrigin::kCached);
  const Field smooth = heat(9);
  EXPECT_EQ(smooth.origin, FieldOrigin::kComputed);
  EXPECT_EQ(smooth.approximation->lambda, 9);
  EXPECT_NE(smooth.distances, usual.distances);
}

TEST_F(ApproximateTest, MatricesAndNearestMembersAreNear) {
  for (const std::string& algorithm : ApproximateAlgorithmNames()) {
    SCOPED_TRACE(algorithm);
    const std::vector<uint32_t> sources = {0, 80}, targets = {8, kMiddle, 72};
    MatrixQuery query = {.mesh_digest = digest_, .algorithm = algorithm};
    for (const uint32_t v : sources) query.sources.push_back({VertexPoint{v}});
    for (const uint32_t v : targets) query.targets.push_back(VertexPoint{v});
    uint64_t rows = 0;
    const absl::StatusOr<AnswerInfo> info = client_.ComputeMatrix(
        query, {.on_row = [&](const MatrixRow& row) {
          for (size_t i = 0; i < targets.size(); ++i) {
            ExpectNear(row.values[i], sources[row.row], targets[i]);
          }
          ++rows;
          return absl::OkStatus();
        }});
    ASSERT_TRUE(info.ok()) << info.status();
    EXPECT_EQ(rows, 2);
    EXPECT_TRUE(info->approximation.has_value());
    EXPECT_EQ(info->relative_tolerance, kInfinity);

    const absl::StatusOr<NearestAnswer> nearest =
        client_.FindNearest({.mesh_digest = digest_,
                             .sources = {{VertexPoint{0}}},
                             .targets = query.targets,
                             .count = 2,
                             .algorithm = algorithm});
    ASSERT_TRUE(nearest.ok()) << nearest.status();
    ASSERT_EQ(nearest->found[0].size(), 2);
    EXPECT_EQ(nearest->found[0][0].target, 1) << "the middle";
    EXPECT_TRUE(nearest->info.approximation.has_value());
  }
}

TEST_F(ApproximateTest, PairsAreNearAndCounted) {
  PairQuery query = {.mesh_digest = digest_};
  for (uint32_t v = 0; v < vertex_count_; ++v) {
    query.pairs.push_back({VertexPoint{v}, VertexPoint{v * v % kVertices}});
  }
  for (const std::string& algorithm : ApproximateAlgorithmNames()) {
    SCOPED_TRACE(algorithm);
    query.algorithm = algorithm;
    const absl::StatusOr<PairAnswer> answer = client_.ComputePairs(query);
    ASSERT_TRUE(answer.ok()) << answer.status();
    for (uint64_t v = 0; v < vertex_count_; ++v) {
      ExpectNear(answer->distances[v], v, v * v % vertex_count_);
    }
    const bool is_searched = algorithm == "svg" || algorithm == "gtu";
    EXPECT_EQ(answer->summary.searched, is_searched ? vertex_count_ : 0);
    EXPECT_EQ(answer->summary.from_cache, 0);
    EXPECT_TRUE(answer->summary.info.approximation.has_value());
  }
  query.algorithm = "";
  EXPECT_FALSE(
      client_.ComputePairs(query)->summary.info.approximation.has_value());
}

TEST_F(ApproximateTest, WhatIsPreparedIsTold) {
  FieldQuery query = {.mesh_digest = digest_,
                      .sources = {{VertexPoint{0}}},
                      .algorithm = "svg",
                      .approximation = {.neighbours = 10}};
  for (int i = 0; i < 2; ++i) {
    const absl::StatusOr<Field> field = client_.ComputeField(query);
    ASSERT_TRUE(field.ok()) << field.status();
    EXPECT_EQ(field->approximation->neighbours, 10);
    const absl::StatusOr<MeshInfo> mesh = client_.GetMesh(digest_);
    ASSERT_THAT(mesh->prepared_methods, SizeIs(1));
    EXPECT_EQ(mesh->prepared_methods[0].algorithm, "svg");
    EXPECT_EQ(mesh->prepared_methods[0].approximation.neighbours, 10);
    EXPECT_GT(mesh->prepared_methods[0].bytes, vertex_count_);
  }
}

TEST_F(ApproximateTest, CommandsTellWhatIsPrepared) {
  Geodesic({"field", grid_, "-s", "0", "-a", "heat", "--lambda", "4"});
  const json info = GeodesicJson({"info", grid_});
  ASSERT_EQ(info["prepared"].size(), 1);
  EXPECT_EQ(info["prepared"][0]["algorithm"], "heat");
  EXPECT_THAT(Geodesic({"info", grid_}).out, HasSubstr("heat, lambda 4"));
}

TEST_F(ApproximateTest, ReportsAndFilesAreMarked) {
  const std::string name = folder_ / "d";
  std::vector<std::string> words = {"field", grid_,  "-s",       "0",
                                    "-a",    "heat", "--lambda", "4",
                                    "-t",    "7",    "--size",   "320x240"};
  for (const char* ending :
       {".csv", ".npy", ".npz", ".ply", ".vtk", ".png", ".html"}) {
    words.insert(words.end(), {"-o", name + ending});
  }
  const json report = GeodesicJson(words);
  EXPECT_EQ(report["approximate"], true);
  EXPECT_EQ(report["parameters"]["lambda"], 4);
  EXPECT_TRUE(report["relative_tolerance"].is_null());
  EXPECT_THAT(FileBytes(name + ".csv"),
              AllOf(HasSubstr("vertex,approximate_distance\n"),
                    Not(HasSubstr("geodesic_distance"))));
  for (const char* ending : {".npy", ".npz", ".ply", ".vtk", ".html"}) {
    EXPECT_THAT(FileBytes(name + ending),
                HasSubstr("approximate: heat, lambda 4"))
        << ending;
  }
  for (const char* ending : {".ply", ".vtk"}) {
    EXPECT_THAT(FileBytes(name + ending),
                AllOf(HasSubstr("approximate_distance"),
                      Not(HasSubstr("geodesic_distance"))))
        << ending;
  }
  EXPECT_THAT(FileBytes(name + ".npz"), HasSubstr("approximate_distances.npy"));
  EXPECT_THAT(Geodesic({"field", grid_, "-s", "0", "-a", "fmm"}).out,
              HasSubstr("approximate: no bound"));

  EXPECT_THAT(
      Geodesic({"matrix", grid_, "-s", "0", "-t", "7", "-a", "fmm"}).out,
      HasSubstr("source,target,approximate_distance"));
  EXPECT_THAT(Geodesic({"distance", grid_, "0", "7", "-a", "svg"}).out,
              HasSubstr("approximate_distance"));
  EXPECT_THAT(Geodesic({"nearest", grid_, "-s", "0", "-t", "7", "-a", "gtu",
                        "--samples", "9"})
                  .out,
              HasSubstr("approximate_distance"));
  const json exact = GeodesicJson({"field", grid_, "-s", "0"});
  EXPECT_EQ(exact["approximate"], false);
}

TEST_F(ApproximateTest, PicturesAreMarked) {
  const auto draw = [&](const std::string& algorithm) {
    const std::string path = folder_ / (algorithm + ".png");
    EXPECT_EQ(Geodesic({"field", grid_, "-s", "0", "-a", algorithm, "--size",
                        "400x300", "-o", path})
                  .exit_code,
              0);
    return FileBytes(path).size();
  };
  // The same plane in the same colours; one has a title more.
  EXPECT_GT(draw("gtu"), draw("fwp-list"));
}

TEST_F(ApproximateTest, WhatTheyCannotDoIsRefusedByName) {
  const auto refused = [&](FieldQuery query) {
    query.mesh_digest = digest_;
    if (query.sources.empty()) query.sources = {{VertexPoint{0}}};
    const absl::StatusOr<Field> field = client_.ComputeField(query);
    EXPECT_TRUE(absl::IsInvalidArgument(field.status())) << field.status();
    return std::string(field.status().message());
  };
  EXPECT_THAT(refused({.algorithm = "heat", .gradients = true}),
              HasSubstr("heat is approximate"));
  EXPECT_THAT(refused({.algorithm = "svg", .targets = {places_[0]}}),
              HasSubstr("targets[0] is no vertex"));
  EXPECT_THAT(refused({.algorithm = "svg", .approximation = {.lambda = 2}}),
              HasSubstr("approximation.lambda is no parameter of svg"));
  EXPECT_THAT(refused({.algorithm = "", .approximation = {.lambda = 2}}),
              HasSubstr("no parameter of an exact algorithm"));
  EXPECT_THAT(refused({.algorithm = "svg", .approximation = {.neighbours = 0}}),
              HasSubstr("K 0"));
  EXPECT_THAT(refused({.sources = {{Curve{{VertexPoint{0}, VertexPoint{1}}}}},
                       .algorithm = "fmm"}),
              HasSubstr("curve"));

  const auto exact_only = [](const absl::Status& status) {
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_THAT(
        std::string(status.message()),
        AllOf(HasSubstr("heat is approximate"), HasSubstr("ComputeField")));
  };
  exact_only(client_
                 .ComputePaths({.mesh_digest = digest_,
                                .sources = {{VertexPoint{0}}},
                                .targets = {VertexPoint{1}},
                                .algorithm = "heat"})
                 .status());
  exact_only(client_
                 .ComputeIsolines({.mesh_digest = digest_,
                                   .sources = {{VertexPoint{0}}},
                                   .levels = {0.5},
                                   .algorithm = "heat"})
                 .status());
  exact_only(client_
                 .SampleFarthestPoints({.mesh_digest = digest_,
                                        .sources = {{VertexPoint{0}}},
                                        .count = 2,
                                        .algorithm = "heat"})
                 .status());
  const absl::StatusOr<PairAnswer> paths =
      client_.ComputePairs({.mesh_digest = digest_,
                            .pairs = {{VertexPoint{0}, VertexPoint{1}}},
                            .paths = true,
                            .algorithm = "svg"});
  EXPECT_TRUE(absl::IsInvalidArgument(paths.status())) << paths.status();
  EXPECT_THAT(Refusal({"path", grid_, "-s", "0", "-t", "1", "-a", "heat"}, 2),
              HasSubstr("heat"));
  EXPECT_THAT(
      Refusal({"field", grid_, "-s", "0", "-a", "fmm", "-o", folder_ / "d.f64"},
              2),
      HasSubstr("no place to say"));
}

}  // namespace
}  // namespace geodesic::client
