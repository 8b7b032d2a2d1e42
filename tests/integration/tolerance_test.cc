// Answers within a tolerance, by library and by command: the exact field is
// within what is certified at each vertex, nobody can take them for exact, and
// what takes no tolerance says so.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/integration/planar_grid_test.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/test_meshes.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// Distances to less than this are called exact.
constexpr double kRounding = 1e-10;

MeshArrays ArraysOf(const TriangleSoup& soup) {
  return {soup.positions, soup.triangles};
}

class ToleranceTest : public IntegrationTest {
 protected:
  void SetUp() override { Upload(ArraysOf(test::Terrain(30, 30, 0.6, 3))); }

  void Upload(const MeshArrays& mesh) {
    mesh_ = mesh;
    digest_ = MeshDigest(mesh);
    ASSERT_TRUE(client_.UploadArrays(mesh).ok());
  }

  FieldQuery From(uint32_t vertex, double tolerance = 0) const {
    return {.mesh_digest = digest_,
            .sources = {{VertexPoint{vertex}}},
            .tolerance = tolerance};
  }

  // The exact distances from a vertex, once nothing within a tolerance is asked
  // for any more: exact fields answer that, too.
  std::vector<double> Truth(uint64_t vertex) {
    const absl::StatusOr<Field> field = client_.ComputeField(From(vertex));
    EXPECT_TRUE(field.ok()) << field.status();
    EXPECT_FALSE(field->certified_error.has_value());
    EXPECT_EQ(field->relative_tolerance, kRounding);
    return field->distances;
  }

  void ExpectCertified(double tolerance) {
    FieldQuery query = From(1, tolerance);
    query.certified_errors = true;
    query.targets = {VertexPoint{5}, FacePoint{9, {0.25, 0.25, 0.5}}};
    const absl::StatusOr<Field> field = client_.ComputeField(query);
    ASSERT_TRUE(field.ok()) << field.status();
    ASSERT_TRUE(field->certified_error.has_value());
    EXPECT_GT(*field->certified_error, 0);
    EXPECT_LE(*field->certified_error, tolerance);
    EXPECT_EQ(field->relative_tolerance, *field->certified_error);
    EXPECT_EQ(field->target_distances[0], field->distances[5]);
    const float largest = *std::ranges::max_element(field->certified_errors);
    EXPECT_EQ(largest, *field->certified_error);
    const std::vector<double> truth = Truth(1);
    ASSERT_EQ(field->certified_errors.size(), truth.size());
    for (size_t v = 0; v < truth.size(); ++v) {
      if (std::isinf(truth[v])) {
        EXPECT_EQ(field->distances[v], truth[v]);
        continue;
      }
      ASSERT_LE(std::abs(field->distances[v] - truth[v]),
                field->certified_errors[v] * truth[v])
          << v;
    }
  }

  MeshArrays mesh_;
  std::string digest_;
  Client client_{server_.address()};
};

TEST_F(ToleranceTest, TheExactFieldIsWithinWhatIsCertified) {
  for (const double tolerance : {1e-5, 1e-3, 0.1}) {
    for (const TriangleSoup& soup :
         {test::Terrain(30, 30, 0.6, 4), test::Icosphere(4),
          test::Torus({.around = 60, .across = 30, .noise = 0.05}),
          test::MakePlate(test::WithHole({.columns = 20, .rows = 20}), 0.3),
          test::Join(test::Terrain(12, 12, 1, 2), test::Icosphere(2))}) {
      Upload(ArraysOf(soup));
      ExpectCertified(tolerance);
      ASSERT_TRUE(client_.DeleteMesh(digest_).ok());
    }
  }
}

TEST_F(ToleranceTest, AlsoOnRealMeshes) {
  int tried = 0;
  for (const char* name : {"real/cgal_elephant.off", "real/fandisk.obj",
                           "hostile/cgal_elephant-with-holes.off"}) {
    const auto soup = test::LoadTestMesh(name);
    if (!soup.ok()) continue;
    SCOPED_TRACE(name);
    ++tried;
    Upload(ArraysOf(*soup));
    ExpectCertified(1e-3);
  }
  if (tried == 0) GTEST_SKIP() << "no test meshes";
}

TEST_F(ToleranceTest, ExactFieldsAnswerAndAreCalledExact) {
  const std::vector<double> truth = Truth(0);
  const absl::StatusOr<Field> field = client_.ComputeField(From(0, 1e-2));
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_EQ(field->origin, FieldOrigin::kCached);
  EXPECT_FALSE(field->certified_error.has_value());
  EXPECT_EQ(field->distances, truth);
}

TEST_F(ToleranceTest, MatricesAndNearestMembersHoldWithinIt) {
  constexpr double kWithin = 1e-2;
  MatrixQuery query = {.mesh_digest = digest_,
                       .sources = {{VertexPoint{0}}, {VertexPoint{500}}},
                       .tolerance = kWithin};
  std::vector<std::vector<double>> rows;
  const absl::StatusOr<AnswerInfo> info = client_.ComputeMatrix(
      query, {.on_row = [&](const MatrixRow& row) {
        rows.emplace_back(row.values.begin(), row.values.end());
        return absl::OkStatus();
      }});
  ASSERT_TRUE(info.ok()) << info.status();
  ASSERT_TRUE(info->certified_error.has_value());
  EXPECT_EQ(info->relative_tolerance, *info->certified_error);
  EXPECT_LE(*info->certified_error, kWithin);
  const std::vector<uint64_t> sources = {0, 500};
  for (size_t row = 0; row < sources.size(); ++row) {
    const std::vector<double> truth = Truth(sources[row]);
    EXPECT_NE(rows[row], truth);
    for (size_t v = 0; v < truth.size(); ++v) {
      ASSERT_LE(std::abs(rows[row][v] - truth[v]),
                *info->certified_error * truth[v]);
    }
  }

  NearestQuery nearest = {.mesh_digest = digest_,
                          .sources = {{VertexPoint{0}}},
                          .count = 5,
                          .tolerance = kWithin};
  for (uint32_t v = 0; v < 400; ++v) {
    nearest.targets.push_back(VertexPoint{2 * v + 1});
  }
  const absl::StatusOr<NearestAnswer> found = client_.FindNearest(nearest);
  ASSERT_TRUE(found.ok()) << found.status();
  ASSERT_EQ(found->found[0].size(), 5);
  EXPECT_LE(found->info.certified_error.value_or(kInfinity), kWithin);
  const std::vector<double> truth = Truth(0);
  for (const NearestTarget& target : found->found[0]) {
    const double expected = truth[2 * target.target + 1];
    EXPECT_LE(std::abs(target.distance - expected), kWithin * expected);
  }
}

TEST_F(ToleranceTest, PairsAndSmallMatricesAreAnsweredByPathsWithinIt) {
  constexpr double kWithin = 1e-2;
  PairQuery query = {.mesh_digest = digest_, .tolerance = kWithin};
  const auto vertex_count = static_cast<uint32_t>(mesh_.positions.size());
  for (uint32_t i = 0; i < 300; ++i) {
    // Some share an end, and are answered by a field.
    query.pairs.push_back({VertexPoint{i % 2 == 0 ? 3 : i},
                           VertexPoint{(i * i + 7) % vertex_count}});
  }
  query.pairs.push_back({FacePoint{9, {0.25, 0.25, 0.5}}, VertexPoint{700}});
  const absl::StatusOr<PairAnswer> found = client_.ComputePairs(query);
  ASSERT_TRUE(found.ok()) << found.status();
  EXPECT_GT(found->summary.searched, 0);
  EXPECT_GT(found->summary.from_fields, 0);
  EXPECT_EQ(found->summary.info.certified_error, kWithin);
  EXPECT_EQ(found->summary.info.relative_tolerance, kWithin);
  query.tolerance = 0;
  const absl::StatusOr<PairAnswer> exact = client_.ComputePairs(query);
  ASSERT_TRUE(exact.ok()) << exact.status();
  EXPECT_FALSE(exact->summary.info.certified_error.has_value());
  EXPECT_NE(found->distances, exact->distances);
  for (size_t i = 0; i < query.pairs.size(); ++i) {
    EXPECT_NEAR(found->distances[i], exact->distances[i],
                kWithin * exact->distances[i]);
  }

  MatrixQuery matrix = {.mesh_digest = digest_,
                        .sources = {{VertexPoint{11}}},
                        .targets = {VertexPoint{600}},
                        .tolerance = kWithin};
  double distance = 0;
  const absl::StatusOr<AnswerInfo> info =
      client_.ComputeMatrix(matrix, {.on_row = [&](const MatrixRow& row) {
                              distance = row.values[0];
                              return absl::OkStatus();
                            }});
  ASSERT_TRUE(info.ok()) << info.status();
  EXPECT_EQ(info->certified_error, kWithin);
  const double truth = Truth(11)[600];
  EXPECT_NEAR(distance, truth, kWithin * truth);
}

TEST_F(ToleranceTest, IsolinesAndSamplesHoldWithinIt) {
  constexpr double kWithin = 1e-2;
  const absl::StatusOr<IsolineAnswer> lines =
      client_.ComputeIsolines({.mesh_digest = digest_,
                               .sources = {{VertexPoint{0}}},
                               .levels = {7, 20},
                               .tolerance = kWithin});
  ASSERT_TRUE(lines.ok()) << lines.status();
  EXPECT_EQ(lines->info.certified_error, kWithin);
  FieldQuery query = From(0);
  std::vector<double> levels;
  for (const Isoline& line : lines->isolines) {
    for (const SurfacePoint& point : line.line.points) {
      query.targets.push_back(point);
      levels.push_back(line.level);
    }
  }
  ASSERT_FALSE(levels.empty());
  const std::vector<double> distances =
      client_.ComputeField(query)->target_distances;
  double largest = 0;
  for (size_t i = 0; i < levels.size(); ++i) {
    const double error = std::abs(distances[i] - levels[i]) / levels[i];
    EXPECT_LE(error, kWithin);
    largest = std::max(largest, error);
  }
  EXPECT_GT(largest, kRounding) << "nothing was merged";

  const absl::StatusOr<SampleAnswer> samples =
      client_.SampleFarthestPoints({.mesh_digest = digest_,
                                    .sources = {{VertexPoint{0}}},
                                    .count = 6,
                                    .tolerance = kWithin});
  ASSERT_TRUE(samples.ok()) << samples.status();
  EXPECT_EQ(samples->info.certified_error, kWithin);
  FieldQuery exact = From(0);
  for (const FarthestSample& sample : samples->samples) {
    const std::vector<double> truth = client_.ComputeField(exact)->distances;
    EXPECT_NEAR(sample.distance, truth[sample.vertex],
                kWithin * truth[sample.vertex]);
    EXPECT_GE(truth[sample.vertex],
              *std::ranges::max_element(truth) * (1 - 2 * kWithin));
    exact.sources.push_back(
        {VertexPoint{static_cast<uint32_t>(sample.vertex)}});
  }
}

TEST_F(ToleranceTest, LimitsHoldWithinIt) {
  FieldQuery query = From(0, 1e-3);
  query.radius = 9;
  const absl::StatusOr<Field> near = client_.ComputeField(query);
  ASSERT_TRUE(near.ok()) << near.status();
  EXPECT_EQ(near->settled_radius, 9);
  EXPECT_TRUE(near->certified_error.has_value());
  query.radius.reset();
  query.targets = {VertexPoint{40}, VertexPoint{700}};
  query.stop_after_targets = 1;
  const absl::StatusOr<Field> stopped = client_.ComputeField(query);
  ASSERT_TRUE(stopped.ok()) << stopped.status();
  const std::vector<double> truth = Truth(0);
  EXPECT_NEAR(stopped->target_distances[0], truth[40], 1e-3 * truth[40]);
  for (size_t v = 0; v < truth.size(); ++v) {
    if (std::isfinite(near->distances[v])) {
      EXPECT_NEAR(near->distances[v], truth[v], 1e-3 * truth[v]);
    } else {
      EXPECT_GT(truth[v], 9 * (1 - 1e-3));
    }
  }
}

// MMP windows run for curves, which are not merged.
TEST_F(ToleranceTest, WhatCannotMergeIsExact) {
  FieldQuery query = From(0, 0.1);
  query.sources = {{Curve{{VertexPoint{0}, VertexPoint{1}}}}};
  const absl::StatusOr<Field> field = client_.ComputeField(query);
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_EQ(field->algorithm, "fwp-mmp");
  EXPECT_FALSE(field->certified_error.has_value());
  EXPECT_EQ(field->relative_tolerance, kRounding);
}

TEST_F(ToleranceTest, WhatTakesNoneIsRefusedByName) {
  const auto refused = [&](FieldQuery query) {
    const absl::StatusOr<Field> field = client_.ComputeField(query);
    EXPECT_TRUE(absl::IsInvalidArgument(field.status())) << field.status();
    return std::string(field.status().message());
  };
  for (const double tolerance : {-1e-3, 1e-10, 0.2, std::nan("")}) {
    EXPECT_THAT(refused(From(0, tolerance)), HasSubstr("tolerance"));
  }
  FieldQuery query = From(0, 1e-3);
  query.algorithm = "fwp-ch";
  EXPECT_THAT(refused(query), HasSubstr("fwp-ch merges no windows"));
  query.algorithm = "heat";
  EXPECT_THAT(refused(query), HasSubstr("heat is approximate"));
  query.algorithm = "fwp-list";
  EXPECT_TRUE(client_.ComputeField(query).ok());
  query.gradients = true;
  EXPECT_THAT(refused(query), HasSubstr("quantities"));
  query.gradients = false;
  EXPECT_TRUE(absl::IsInvalidArgument(
      client_.StreamField(query, [](auto) {}).status()));
  query = From(0);
  query.algorithm = "fmm";
  query.certified_errors = true;
  EXPECT_THAT(refused(query), HasSubstr("certifies nothing"));
}

class ToleranceCommandTest : public ToleranceTest {
 protected:
  void SetUp() override {
    ToleranceTest::SetUp();
    WriteFile(file_, OffText(mesh_));
  }

  // What the command says when it refuses.
  std::string Refusal(const std::vector<std::string>& words,
                      int exit_code = 2) const {
    const ProcessResult result = Geodesic(words);
    EXPECT_EQ(result.exit_code, exit_code);
    return result.err;
  }

  const std::string file_ = folder_ / "terrain.off";
};

TEST_F(ToleranceCommandTest, ReportsAndFilesAreMarked) {
  const std::string name = folder_ / "d";
  std::vector<std::string> words = {
      "field",  file_,         "-s",
      "0",      "--tolerance", "1e-3",
      "--size", "320x240",     "--certified-errors"};
  for (const char* ending :
       {".csv", ".npy", ".npz", ".ply", ".vtk", ".png", ".html"}) {
    words.insert(words.end(), {"-o", name + ending});
  }
  const json report = GeodesicJson(words);
  EXPECT_EQ(report["approximate"], false);
  EXPECT_GT(report["certified_error"], 0);
  EXPECT_LE(report["certified_error"], 1e-3);
  EXPECT_THAT(
      FileBytes(name + ".csv"),
      AllOf(HasSubstr("vertex,distance_within_tolerance,certified_error\n"),
            Not(HasSubstr("geodesic_distance"))));
  for (const char* ending : {".npy", ".npz", ".ply", ".vtk", ".html"}) {
    EXPECT_THAT(FileBytes(name + ending),
                HasSubstr("within 0.001 (relative error)"))
        << ending;
  }
  for (const char* ending : {".ply", ".vtk"}) {
    EXPECT_THAT(FileBytes(name + ending),
                AllOf(HasSubstr("distance_within_tolerance"),
                      HasSubstr("certified_error"),
                      Not(HasSubstr("geodesic_distance"))))
        << ending;
  }
  EXPECT_THAT(FileBytes(name + ".npz"),
              AllOf(HasSubstr("distances_within_tolerance.npy"),
                    HasSubstr("certified_errors.npy")));
  EXPECT_THAT(Geodesic({"field", file_, "-s", "0", "--tolerance", "1e-3"}).out,
              HasSubstr("certified within"));
  const json exact = GeodesicJson({"field", file_, "-s", "0"});
  EXPECT_TRUE(exact["certified_error"].is_null());
}

TEST_F(ToleranceCommandTest, SoAreThoseOfOtherQuestions) {
  const std::string name = folder_ / "d";
  EXPECT_THAT(Geodesic({"matrix", file_, "-s", "0", "--tolerance", "0.01"}).out,
              HasSubstr("source,target,distance_within_tolerance"));
  EXPECT_GT(GeodesicJson({"matrix", file_, "-s", "0", "--tolerance", "0.01",
                          "-o", name + ".npz"})["certified_error"],
            0);
  EXPECT_THAT(FileBytes(name + ".npz"), HasSubstr("within_tolerance.npy"));
  EXPECT_THAT(
      Geodesic({"nearest", file_, "-s", "0", "-t", "7", "--tolerance", "0.01"})
          .out,
      HasSubstr("distance_within_tolerance"));
  EXPECT_THAT(
      Geodesic({"distance", file_, "0", "700", "--tolerance", "0.01"}).out,
      AllOf(HasSubstr("distance_within_tolerance"),
            HasSubstr("certified within 0.01")));
  WriteFile(name + ".txt", "1 700\n2 800\n");
  EXPECT_EQ(GeodesicJson({"distance", file_, "--pairs", name + ".txt",
                          "--tolerance", "0.01", "-o", name + ".npy", "-o",
                          name + ".csv"})["certified_error"],
            0.01);
  EXPECT_THAT(FileBytes(name + ".csv"),
              HasSubstr("source,target,distance_within_tolerance"));
  EXPECT_EQ(
      GeodesicJson({"isolines", file_, "-s", "0", "-n", "3", "--tolerance",
                    "0.01", "-o", name + ".obj", "-o", name + ".csv", "-o",
                    name + ".png", "--size", "320x240"})["certified_error"],
      0.01);
  for (const char* ending : {".obj", ".csv"}) {
    EXPECT_THAT(FileBytes(name + ending), HasSubstr("level_within_tolerance"));
  }
  EXPECT_EQ(
      GeodesicJson({"sample", file_, "-n", "3", "--tolerance", "0.01", "-o",
                    name + ".ply", "-o", name + ".csv"})["certified_error"],
      0.01);
  EXPECT_THAT(FileBytes(name + ".csv"),
              HasSubstr("vertex,distance_within_tolerance,x"));
  EXPECT_THAT(FileBytes(name + ".ply"),
              AllOf(HasSubstr("distance_within_tolerance"),
                    HasSubstr("within 0.01 (relative error)")));
}

TEST_F(ToleranceCommandTest, WrongOnesAreRefused) {
  EXPECT_THAT(Refusal({"field", file_, "-s", "0", "--tolerance", "0.5"}),
              HasSubstr("from 1e-9 to 0.1"));
  EXPECT_THAT(
      Refusal({"field", file_, "-s", "0", "--tolerance", "1e-3", "-a", "heat"}),
      HasSubstr("heat is approximate"));
  EXPECT_THAT(
      Refusal({"field", file_, "-s", "0", "--tolerance", "1e-3", "-a", "mmp"},
              /*exit_code=*/5),
      HasSubstr("mmp merges no windows"));
  EXPECT_THAT(Refusal({"field", file_, "-s", "0", "--tolerance", "1e-3",
                       "--progressive"}),
              HasSubstr("--tolerance"));
  EXPECT_THAT(Refusal({"field", file_, "-s", "0", "--tolerance", "1e-3", "-o",
                       folder_ / "d.f64"}),
              HasSubstr("within a tolerance"));
  EXPECT_THAT(
      Refusal({"path", file_, "-s", "0", "-t", "7", "--tolerance", "1e-3"}),
      HasSubstr("--tolerance"));
  EXPECT_THAT(Refusal({"distance", file_, "0", "7", "--tolerance", "1e-3", "-a",
                       "svg"}),
              HasSubstr("svg is approximate"));
}

}  // namespace
}  // namespace geodesic::client
