// Fields: places, limits, quantities and streams, by library and by command.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/integration/planar_grid_test.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class FieldQuestionsTest : public PlanarGridTest {};

TEST_F(FieldQuestionsTest, SourcesAndTargetsLieAnywhere) {
  for (const SurfacePoint& place : places_) {
    Source source = {.offset = 0.125};
    std::visit([&](const auto& at) { source.place = at; }, place);
    absl::StatusOr<Field> field = client_.ComputeField(
        {.mesh_digest = digest_, .sources = {source}, .targets = places_});
    ASSERT_TRUE(field.ok()) << field.status();
    const Point from = Where(place);
    for (uint64_t v = 0; v < vertex_count_; ++v) {
      ASSERT_NEAR(field->distances[v], 0.125 + Euclid(from, At(v)), kTolerance);
    }
    ASSERT_EQ(field->target_distances.size(), places_.size());
    for (size_t i = 0; i < places_.size(); ++i) {
      EXPECT_NEAR(field->target_distances[i],
                  0.125 + Euclid(from, Where(places_[i])), kTolerance);
    }
    EXPECT_EQ(field->settled_radius, kInfinity);
  }
}

TEST_F(FieldQuestionsTest, CurvesAreMeasuredFromEveryPoint) {
  // The left side of the square: the distance is x.
  Curve side;
  for (uint64_t j = 0; j <= kGrid; ++j) {
    side.points.push_back(VertexPoint{j * (kGrid + 1)});
  }
  absl::StatusOr<Field> field =
      client_.ComputeField({.mesh_digest = digest_, .sources = {{side, 0.5}}});
  ASSERT_TRUE(field.ok()) << field.status();
  for (uint64_t v = 0; v < vertex_count_; ++v) {
    ASSERT_NEAR(field->distances[v], 0.5 + At(v)[0], kTolerance);
  }
}

TEST_F(FieldQuestionsTest, FloatsAreTheNearestOnes) {
  const FieldQuery doubles = {.mesh_digest = digest_,
                              .sources = {{VertexPoint{7}}}};
  FieldQuery floats = doubles;
  floats.value_type = ValueType::kFloat32;
  absl::StatusOr<Field> wide = client_.ComputeField(doubles);
  absl::StatusOr<Field> narrow = client_.ComputeField(floats);
  ASSERT_TRUE(wide.ok() && narrow.ok());
  for (uint64_t v = 0; v < vertex_count_; ++v) {
    ASSERT_EQ(narrow->distances[v], static_cast<float>(wide->distances[v]));
  }
}

TEST_F(FieldQuestionsTest, FieldPrintsTargets) {
  const json field = GeodesicJson(
      {"field", grid_, "-s", "0", "-t", "80", "-t", "edge:0-1@0.5"});
  ASSERT_EQ(field["targets"].size(), 2);
  EXPECT_EQ(field["targets"][0]["vertex"], 80);
  EXPECT_NEAR(field["targets"][0]["distance"], std::sqrt(2), kTolerance);
  EXPECT_NEAR(field["targets"][1]["distance"], 0.5 / kGrid, kTolerance);
  EXPECT_THAT(Geodesic({"field", grid_, "-s", "0", "-t", "edge:0-1@0.5"}).out,
              HasSubstr("to edge:0-1@0.5"));
}

TEST_F(FieldQuestionsTest, FieldStopsAtARadius) {
  const json field = GeodesicJson(
      {"field", grid_, "-s", "0", "-r", "0.5", "-o", folder_ / "d.csv"});
  EXPECT_GE(field["settled_radius"], 0.5);
  EXPECT_LE(field["largest_distance"], 0.5);
  size_t reached = 0;
  for (const std::vector<double>& row : Rows(FileBytes(folder_ / "d.csv"))) {
    const double expected = Euclid(At(0), At(static_cast<size_t>(row[0])));
    if (expected <= 0.5) {
      EXPECT_NEAR(row[1], expected, kTolerance);
      ++reached;
    } else {
      EXPECT_TRUE(std::isinf(row[1]));
    }
  }
  EXPECT_EQ(field["unreachable_vertices"], vertex_count_ - reached);
  EXPECT_THAT(Geodesic({"field", grid_, "-s", "0", "-r", "0.5"}).out,
              HasSubstr("exact up to"));
}

TEST_F(FieldQuestionsTest, FieldStopsAtTargets) {
  for (const int count : {1, 2}) {
    const json targets = GeodesicJson(
        {"field", grid_, "-s", "0", "-t", "edge:0-1@0.5", "-t", "80",
         "--stop-at-targets=" + std::to_string(count)})["targets"];
    EXPECT_NEAR(targets[0]["distance"], 0.5 / kGrid, kTolerance);
    if (count == 2) {
      EXPECT_NEAR(targets[1]["distance"], std::sqrt(2), kTolerance);
    }
  }
  EXPECT_THAT(
      Refusal({"field", grid_, "-s", "0", "-t", "1", "--stop-at-targets=2"}, 5),
      HasSubstr("target"));
}

TEST_F(FieldQuestionsTest, FieldHasNearestSourcesAndGradients) {
  GeodesicJson({"field", grid_, "-s", "0", "-s", "80:0.1", "-s", "edge:5-6@0.5",
                "--nearest-sources", "--gradients", "-o", folder_ / "d.csv",
                "-o", folder_ / "d.npz", "-o", folder_ / "d.png", "--size",
                "320x240"});
  const std::vector<Point> from = {At(0), At(80), Where(EdgePoint{5, 6, 0.5})};
  for (const std::vector<double>& row : Rows(FileBytes(folder_ / "d.csv"))) {
    ASSERT_EQ(row.size(), 6);
    const Point& at = At(static_cast<size_t>(row[0]));
    const Point& source = from.at(static_cast<size_t>(row[2]));
    const double length = Euclid(source, at);
    EXPECT_NEAR(row[1], length + (row[2] == 1 ? 0.1 : 0), kTolerance);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(row[3 + axis],
                  length == 0 ? 0 : (at[axis] - source[axis]) / length, 1e-9);
    }
  }
  const std::string npz = FileBytes(folder_ / "d.npz");
  for (const char* member :
       {"distances.npy", "nearest_sources.npy", "gradients.npy"}) {
    EXPECT_THAT(npz, HasSubstr(member));
  }
  EXPECT_THAT(FileBytes(folder_ / "d.png"), StartsWith("\x89PNG"));
}

TEST_F(FieldQuestionsTest, FieldSourcesComeFromFilesAndCurves) {
  WriteFile(folder_ / "sources.txt", "# corners\n0\n80:0.25\n");
  const json field =
      GeodesicJson({"field", grid_, "--sources", folder_ / "sources.txt",
                    "--curve", "8;17", "-s", "40", "-o", folder_ / "d.f64"});
  const json& sources = field["sources"];
  ASSERT_EQ(sources.size(), 4);
  EXPECT_EQ(sources[0]["vertex"], 40);
  EXPECT_EQ(sources[1]["curve"].size(), 2);
  EXPECT_EQ(sources[2]["vertex"], 0);
  EXPECT_EQ(sources[3]["offset"], 0.25);
  EXPECT_THAT(Refusal({"field", grid_, "--sources", folder_ / "no.txt"}, 3),
              HasSubstr("no.txt"));
}

TEST_F(FieldQuestionsTest, FieldStreamsWhatIsSettled) {
  const ProcessResult result =
      Geodesic({"field", grid_, "-s", "0", "--progressive"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, StartsWith("vertex,geodesic_distance\n"));
  const std::vector<std::vector<double>> rows = Rows(result.out);
  ASSERT_EQ(rows.size(), vertex_count_);
  std::set<double> seen;
  for (size_t i = 0; i < rows.size(); ++i) {
    EXPECT_NEAR(rows[i][1], Euclid(At(0), At(static_cast<size_t>(rows[i][0]))),
                kTolerance);
    EXPECT_GE(rows[i][1], rows[i == 0 ? 0 : i - 1][1]);
    seen.insert(rows[i][0]);
  }
  EXPECT_EQ(seen.size(), vertex_count_);
  const json stream = GeodesicJson(
      {"field", grid_, "-s", "0", "--progressive", "-o", folder_ / "d.csv"});
  EXPECT_EQ(Rows(FileBytes(folder_ / "d.csv")), rows);
  EXPECT_EQ(stream["outputs"][0]["bytes"], FileBytes(folder_ / "d.csv").size());
}

}  // namespace
}  // namespace geodesic::client
