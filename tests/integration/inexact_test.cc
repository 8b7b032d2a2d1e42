// Approximate algorithms and answers within a tolerance, by library and by
// command: what they refuse, and that nobody can take them for exact. That
// answers to all questions are near the exact ones, or within what is
// certified, also a server's, is seen by approximate_test.py and
// tolerance_test.py in tests/python.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/integration/planar_grid_test.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

using Words = std::vector<std::string>;

class InexactTest : public PlanarGridTest {
 protected:
  void SetUp() override {
    PlanarGridTest::SetUp();
    const TriangleSoup soup = test::Terrain(30, 30, 0.6, 3);
    const MeshArrays terrain = {soup.positions, soup.triangles};
    WriteFile(terrain_, OffText(terrain));
    terrain_digest_ = MeshDigest(terrain);
    ASSERT_TRUE(client_.UploadArrays(terrain).ok());
  }

  // Distances from a vertex of the terrain.
  FieldQuery From(uint32_t vertex, double tolerance) const {
    return {.mesh_digest = terrain_digest_,
            .sources = {{VertexPoint{vertex}}},
            .tolerance = tolerance};
  }

  // Expects files of a field to tell `mark`, and what they call distances to
  // begin with `name`. Returns the report.
  json ExpectMarked(Words words, const std::string& name,
                    const std::string& plural, const std::string& mark) const {
    const std::string path = folder_ / "d";
    words.insert(words.end(), {"--size", "320x240"});
    for (const char* ending :
         {".csv", ".npy", ".npz", ".ply", ".vtk", ".png", ".html"}) {
      words.insert(words.end(), {"-o", path + ending});
    }
    const json report = GeodesicJson(words);
    EXPECT_THAT(FileBytes(path + ".csv"), HasSubstr("vertex," + name));
    for (const char* ending : {".npy", ".npz", ".ply", ".vtk", ".html"}) {
      EXPECT_THAT(FileBytes(path + ending), HasSubstr(mark)) << ending;
    }
    for (const char* ending : {".csv", ".ply", ".vtk"}) {
      EXPECT_THAT(FileBytes(path + ending),
                  AllOf(HasSubstr(name), Not(HasSubstr("geodesic_distance"))))
          << ending;
    }
    EXPECT_THAT(FileBytes(path + ".npz"), HasSubstr(plural + ".npy"));
    return report;
  }

  const std::string terrain_ = folder_ / "terrain.off";
  std::string terrain_digest_;
};

TEST_F(InexactTest, ApproximateFieldsSaySo) {
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
    EXPECT_TRUE(field->approximation.has_value());
    EXPECT_EQ(field->relative_tolerance, kInfinity);
    EXPECT_EQ(field->settled_radius, 0);
    // Fronts around a source are not straight.
    EXPECT_NEAR(field->target_distances[0], std::sqrt(0.5), 0.08);
    EXPECT_EQ(field->target_distances[0], field->distances[kMiddle]);
  }
  const absl::StatusOr<Field> exact = client_.ComputeField(
      {.mesh_digest = digest_, .sources = {{VertexPoint{0}}}});
  EXPECT_EQ(exact->origin, FieldOrigin::kComputed);
  EXPECT_FALSE(exact->approximation.has_value());
}

TEST_F(InexactTest, FieldsWithinAToleranceSayWhatIsCertified) {
  FieldQuery query = From(1, 1e-3);
  query.certified_errors = true;
  const absl::StatusOr<Field> field = client_.ComputeField(query);
  ASSERT_TRUE(field.ok()) << field.status();
  ASSERT_TRUE(field->certified_error.has_value());
  EXPECT_GT(*field->certified_error, 0);
  EXPECT_LE(*field->certified_error, 1e-3);
  EXPECT_EQ(field->relative_tolerance, *field->certified_error);
  EXPECT_EQ(*std::ranges::max_element(field->certified_errors),
            *field->certified_error);
  // Exact fields answer for another tolerance as well, and are called exact.
  for (const double tolerance : {0.0, 1e-2}) {
    const absl::StatusOr<Field> exact =
        client_.ComputeField(From(1, tolerance));
    ASSERT_TRUE(exact.ok()) << exact.status();
    EXPECT_FALSE(exact->certified_error.has_value());
    EXPECT_EQ(exact->relative_tolerance, 1e-10);
    EXPECT_NE(exact->distances, field->distances);
    for (size_t v = 0; v < exact->distances.size(); ++v) {
      ASSERT_LE(std::abs(field->distances[v] - exact->distances[v]),
                field->certified_errors[v] * exact->distances[v]);
    }
  }
}

TEST_F(InexactTest, ReportsAndFilesOfFieldsAreMarked) {
  const json approximate = ExpectMarked(
      {"field", grid_, "-s", "0", "-a", "heat", "--lambda", "4", "-t", "7"},
      "approximate_distance", "approximate_distances",
      "approximate: heat, lambda 4");
  EXPECT_EQ(approximate["approximate"], true);
  EXPECT_EQ(approximate["parameters"]["lambda"], 4);
  EXPECT_TRUE(approximate["relative_tolerance"].is_null());
  EXPECT_THAT(Geodesic({"field", grid_, "-s", "0", "-a", "fmm"}).out,
              HasSubstr("approximate: no bound"));

  const Words within = {"field", terrain_, "-s", "0", "--tolerance", "1e-3"};
  Words with_errors = within;
  with_errors.push_back("--certified-errors");
  const json certified = ExpectMarked(with_errors, "distance_within_tolerance",
                                      "distances_within_tolerance",
                                      "within 0.001 (relative error)");
  EXPECT_EQ(certified["approximate"], false);
  EXPECT_GT(certified["certified_error"], 0);
  EXPECT_LE(certified["certified_error"], 1e-3);
  for (const char* ending : {".csv", ".npz", ".ply", ".vtk"}) {
    EXPECT_THAT(FileBytes(folder_ / "d" + ending), HasSubstr("certified_error"))
        << ending;
  }
  EXPECT_THAT(Geodesic(within).out, HasSubstr("certified within"));
  const json exact = GeodesicJson({"field", terrain_, "-s", "0"});
  EXPECT_EQ(exact["approximate"], false);
  EXPECT_TRUE(exact["certified_error"].is_null());
}

TEST_F(InexactTest, SoAreThoseOfOtherQuestions) {
  EXPECT_THAT(
      Geodesic({"matrix", grid_, "-s", "0", "-t", "7", "-a", "fmm"}).out,
      HasSubstr("source,target,approximate_distance"));
  EXPECT_THAT(Geodesic({"distance", grid_, "0", "7", "-a", "svg"}).out,
              HasSubstr("approximate_distance"));
  EXPECT_THAT(Geodesic({"nearest", grid_, "-s", "0", "-t", "7", "-a", "gtu",
                        "--samples", "9"})
                  .out,
              HasSubstr("approximate_distance"));

  const std::string name = folder_ / "d";
  const auto within = [&](Words words) {
    words.insert(words.begin() + 1, terrain_);
    words.insert(words.end(), {"--tolerance", "0.01"});
    return words;
  };
  EXPECT_THAT(Geodesic(within({"matrix", "-s", "0"})).out,
              HasSubstr("source,target,distance_within_tolerance"));
  EXPECT_GT(GeodesicJson(within(
                {"matrix", "-s", "0", "-o", name + ".npz"}))["certified_error"],
            0);
  EXPECT_THAT(FileBytes(name + ".npz"), HasSubstr("within_tolerance.npy"));
  EXPECT_THAT(Geodesic(within({"nearest", "-s", "0", "-t", "7"})).out,
              AllOf(HasSubstr("distance_within_tolerance"),
                    HasSubstr("certified within")));
  EXPECT_THAT(Geodesic(within({"distance", "0", "700"})).out,
              AllOf(HasSubstr("distance_within_tolerance"),
                    HasSubstr("certified within 0.01")));
  WriteFile(name + ".txt", "1 700\n2 800\n");
  EXPECT_EQ(GeodesicJson(within({"distance", "--pairs", name + ".txt", "-o",
                                 name + ".npy", "-o",
                                 name + ".csv"}))["certified_error"],
            0.01);
  EXPECT_THAT(FileBytes(name + ".csv"),
              HasSubstr("source,target,distance_within_tolerance"));
  EXPECT_EQ(GeodesicJson(
                within({"isolines", "-s", "0", "-n", "3", "-o", name + ".obj",
                        "-o", name + ".csv", "-o", name + ".png", "--size",
                        "320x240"}))["certified_error"],
            0.01);
  for (const char* ending : {".obj", ".csv"}) {
    EXPECT_THAT(FileBytes(name + ending), HasSubstr("level_within_tolerance"));
  }
  EXPECT_EQ(GeodesicJson(within({"sample", "-n", "3", "-o", name + ".ply", "-o",
                                 name + ".csv"}))["certified_error"],
            0.01);
  EXPECT_THAT(FileBytes(name + ".csv"),
              HasSubstr("vertex,distance_within_tolerance,x"));
  EXPECT_THAT(FileBytes(name + ".ply"),
              AllOf(HasSubstr("distance_within_tolerance"),
                    HasSubstr("within 0.01 (relative error)")));
}

TEST_F(InexactTest, PicturesAreMarked) {
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

TEST_F(InexactTest, CommandsTellWhatIsPrepared) {
  Geodesic({"field", grid_, "-s", "0", "-a", "heat", "--lambda", "4"});
  const json info = GeodesicJson({"info", grid_});
  ASSERT_EQ(info["prepared"].size(), 1);
  EXPECT_EQ(info["prepared"][0]["algorithm"], "heat");
  EXPECT_THAT(Geodesic({"info", grid_}).out, HasSubstr("heat, lambda 4"));
}

TEST_F(InexactTest, WhatTheyCannotDoIsRefusedByName) {
  const auto expect_refused = [](const absl::Status& status, const auto& says) {
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_THAT(std::string(status.message()), says);
  };
  const std::vector<Source> from = {{VertexPoint{0}}};
  const std::vector<Source> side = {{Curve{{VertexPoint{0}, VertexPoint{1}}}}};
  const std::vector<SurfacePoint> to = {VertexPoint{1}};
  const std::vector<std::pair<FieldQuery, std::string>> fields = {
      {{.sources = from, .algorithm = "heat", .gradients = true},
       "heat is approximate"},
      {{.sources = from, .algorithm = "svg", .targets = {places_[0]}},
       "targets[0] is no vertex"},
      {{.sources = from, .algorithm = "svg", .approximation = {.lambda = 2}},
       "approximation.lambda is no parameter of svg"},
      {{.sources = from, .approximation = {.lambda = 2}},
       "no parameter of an exact algorithm"},
      {{.sources = from,
        .algorithm = "svg",
        .approximation = {.neighbours = 0}},
       "K 0"},
      {{.sources = side, .algorithm = "fmm"}, "curve"},
      {{.sources = from, .algorithm = "fmm", .certified_errors = true},
       "certifies nothing"},
      {{.sources = from, .algorithm = "heat", .tolerance = 1e-3},
       "heat is approximate"},
      {{.sources = from, .tolerance = 0.2}, "tolerance"},
      {{.sources = from, .tolerance = 1e-3, .gradients = true}, "quantities"}};
  for (auto [query, says] : fields) {
    query.mesh_digest = digest_;
    expect_refused(client_.ComputeField(query).status(), HasSubstr(says));
  }
  expect_refused(client_.StreamField(From(0, 1e-3), [](auto) {}).status(),
                 HasSubstr("progressive"));
  const auto exact_only =
      AllOf(HasSubstr("heat is approximate"), HasSubstr("ComputeField"));
  expect_refused(client_
                     .ComputePaths({.mesh_digest = digest_,
                                    .sources = from,
                                    .targets = to,
                                    .algorithm = "heat"})
                     .status(),
                 exact_only);
  expect_refused(client_
                     .ComputeIsolines({.mesh_digest = digest_,
                                       .sources = from,
                                       .levels = {0.5},
                                       .algorithm = "heat"})
                     .status(),
                 exact_only);
  expect_refused(client_
                     .SampleFarthestPoints({.mesh_digest = digest_,
                                            .sources = from,
                                            .count = 2,
                                            .algorithm = "heat"})
                     .status(),
                 exact_only);
  expect_refused(client_
                     .ComputePairs({.mesh_digest = digest_,
                                    .pairs = {{VertexPoint{0}, VertexPoint{1}}},
                                    .paths = true,
                                    .algorithm = "svg"})
                     .status(),
                 HasSubstr("svg is approximate"));
}

TEST_F(InexactTest, SoItIsByTheCommand) {
  const Words field = {"field", grid_, "-s", "0"};
  for (const auto& [more, says] : std::vector<std::pair<Words, std::string>>{
           {{"-a", "fmm", "-o", folder_ / "d.f64"}, "no place to say"},
           {{"--tolerance", "0.5"}, "from 1e-9 to 0.1"},
           {{"--tolerance", "1e-3", "-a", "heat"}, "heat is approximate"},
           {{"--tolerance", "1e-3", "--progressive"}, "--tolerance"},
           {{"--tolerance", "1e-3", "-o", folder_ / "d.f64"},
            "within a tolerance"}}) {
    Words words = field;
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_THAT(Refusal(words), HasSubstr(says));
  }
  EXPECT_THAT(
      Refusal({"field", grid_, "-s", "0", "--tolerance", "1e-3", "-a", "mmp"},
              /*exit_code=*/5),
      HasSubstr("mmp merges no windows"));
  EXPECT_THAT(Refusal({"path", grid_, "-s", "0", "-t", "1", "-a", "heat"}),
              HasSubstr("heat"));
  EXPECT_THAT(
      Refusal({"path", grid_, "-s", "0", "-t", "7", "--tolerance", "1e-3"}),
      HasSubstr("--tolerance"));
  EXPECT_THAT(Refusal({"distance", grid_, "0", "7", "--tolerance", "1e-3", "-a",
                       "svg"}),
              HasSubstr("svg is approximate"));
}

}  // namespace
}  // namespace geodesic::client
