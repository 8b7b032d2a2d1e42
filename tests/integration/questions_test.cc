// Every question, by the command, which asks through the library. What the
// library makes of answers is in tests/client/answers_test.cc.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "tests/integration/planar_grid_test.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// Fields: places, limits, quantities and streams.
using FieldQuestionsTest = PlanarGridTest;

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
  const json field =
      GeodesicJson({"field", grid_, "-s", "0", "-t", "80", "-t", "edge:0-1@0.5",
                    "-t", "face:40@0.2,0.3,0.5"});
  ASSERT_EQ(field["targets"].size(), 3);
  EXPECT_EQ(field["targets"][0]["vertex"], 80);
  EXPECT_NEAR(field["targets"][0]["distance"], std::sqrt(2), kTolerance);
  EXPECT_NEAR(field["targets"][1]["distance"], 0.5 / kGrid, kTolerance);
  EXPECT_NEAR(field["targets"][2]["distance"], Euclid(At(0), Where(places_[0])),
              kTolerance);
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
  GeodesicJson({"field",
                grid_,
                "-s",
                "0",
                "-s",
                "80:0.1",
                "-s",
                "edge:5-6@0.5",
                "-s",
                "face:101@0.2,0.3,0.5",
                "--nearest-sources",
                "--gradients",
                "-o",
                folder_ / "d.csv",
                "-o",
                folder_ / "d.npz",
                "-o",
                folder_ / "d.png",
                "--size",
                "320x240"});
  const std::vector<Point> from = {At(0), At(80), Where(EdgePoint{5, 6, 0.5}),
                                   Where(FacePoint{101, {0.2, 0.3, 0.5}})};
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
  // A curve up the right side of the square.
  const json field =
      GeodesicJson({"field", grid_, "--sources", folder_ / "sources.txt",
                    "--curve", "8;17", "-s", "40", "-o", folder_ / "d.csv"});
  const json& sources = field["sources"];
  ASSERT_EQ(sources.size(), 4);
  EXPECT_EQ(sources[0]["vertex"], 40);
  EXPECT_EQ(sources[1]["curve"].size(), 2);
  EXPECT_EQ(sources[2]["vertex"], 0);
  EXPECT_EQ(sources[3]["offset"], 0.25);
  for (const std::vector<double>& row : Rows(FileBytes(folder_ / "d.csv"))) {
    const Point& p = At(static_cast<size_t>(row[0]));
    const Point on_curve = {1, std::min(p[1], 1.0 / kGrid), 0};
    EXPECT_NEAR(row[1],
                std::min({Euclid(p, At(40)), Euclid(p, on_curve),
                          Euclid(p, At(0)), 0.25 + Euclid(p, At(80))}),
                kTolerance);
  }
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

// Shortest paths and isolines.
using LineQuestionsTest = PlanarGridTest;

TEST_F(LineQuestionsTest, PathIsStraight) {
  std::vector<std::string> words = {
      "path",   grid_,    "-s", "80:9", "-s", "0:0.25",
      "-t",     "79",     "-t", "0",    "-t", "face:40@0.2,0.3,0.5",
      "--size", "320x240"};
  for (const char* ending : {".obj", ".ply", ".vtk", ".csv", ".json", ".png"}) {
    words.insert(words.end(), {"-o", folder_ / "p" + ending});
  }
  const json answer = GeodesicJson(words);
  const json& path = answer["paths"][0];
  EXPECT_EQ(path["source"], 1);
  const double length = path["length"];
  EXPECT_NEAR(length, Euclid(At(0), At(79)), kTolerance);
  EXPECT_NEAR(path["distance"], 0.25 + length, kTolerance);
  for (const json& p : path["positions"]) {
    // On the line from (0, 0) to (7/8, 1).
    EXPECT_NEAR(p[0].get<double>(), 7.0 / 8 * p[1].get<double>(), kTolerance);
  }
  EXPECT_NEAR(answer["paths"][2]["length"], Euclid(At(0), Where(places_[0])),
              kTolerance);
  EXPECT_EQ(answer["paths"][1]["length"], 0);
  EXPECT_EQ(answer["outputs"].size(), 6);
  for (const json& output : answer["outputs"]) {
    EXPECT_EQ(output["bytes"],
              FileBytes(output["path"].get<std::string>()).size());
  }
  const json features = json::parse(FileBytes(folder_ / "p.json"))["features"];
  EXPECT_EQ(features[0]["geometry"]["coordinates"], path["positions"]);
  EXPECT_EQ(features[0]["properties"]["points"], path["points"]);
  EXPECT_THAT(FileBytes(folder_ / "p.obj"), HasSubstr("\nl 1 2\n"));
  EXPECT_THAT(Geodesic({"path", grid_, "-s", "0", "-t", "79"}).out,
              StartsWith("target  source"));
}

TEST_F(LineQuestionsTest, IsolinesLieAtTheirLevels) {
  const json answer = GeodesicJson({"isolines", grid_, "-s", "40", "-l", "0.3",
                                    "-l", "0.4", "-o", folder_ / "l.csv", "-o",
                                    folder_ / "l.png", "--size", "320x240"});
  ASSERT_EQ(answer["levels"].size(), 2);
  EXPECT_EQ(answer["levels"][0]["lines"], 1);
  EXPECT_EQ(answer["levels"][0]["closed"], 1);
  // The polyline cuts the circle short, by a thousandth at the most; by less
  // where chords are nearer.
  const double length = answer["levels"][0]["length"];
  EXPECT_LT(length, 2 * M_PI * 0.3);
  EXPECT_GT(length, 0.999 * 2 * M_PI * 0.3);
  const json nearer = GeodesicJson(
      {"isolines", grid_, "-s", "40", "-l", "0.3", "--chord-error", "1e-8"});
  EXPECT_LT(length, nearer["levels"][0]["length"]);
  EXPECT_NEAR(nearer["levels"][0]["length"], 2 * M_PI * 0.3, 1e-6);
  for (const std::vector<double>& row : Rows(FileBytes(folder_ / "l.csv"))) {
    EXPECT_NEAR(Euclid({row[2], row[3], row[4]}, At(40)), row.back(),
                kTolerance);
  }
  // Three levels cut the largest distance, that of a corner, into four.
  const json spread =
      GeodesicJson({"isolines", grid_, "-s", "40", "--count", "3"});
  ASSERT_EQ(spread["levels"].size(), 3);
  EXPECT_NEAR(spread["levels"][1]["level"], std::sqrt(0.5) / 2, kTolerance);
}

// Distance matrices and nearest members.
using MatrixQuestionsTest = PlanarGridTest;

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

// Farthest-point samples and log maps.
using PointQuestionsTest = PlanarGridTest;

TEST_F(PointQuestionsTest, SamplesAreFarApart) {
  const json answer =
      GeodesicJson({"sample", grid_, "-n", "3", "-o", folder_ / "s.csv", "-o",
                    folder_ / "s.ply", "-o", folder_ / "s.json"});
  // From one corner: the opposite one, then the two others.
  ASSERT_EQ(answer["samples"].size(), 3);
  EXPECT_EQ(answer["samples"][0]["vertex"], 80);
  EXPECT_NEAR(answer["samples"][0]["distance"], std::sqrt(2), kTolerance);
  EXPECT_NEAR(answer["samples"][1]["distance"], 1, kTolerance);
  EXPECT_NEAR(answer["samples"][2]["distance"], 1, kTolerance);
  EXPECT_EQ(Rows(FileBytes(folder_ / "s.csv")).size(), 3);
  EXPECT_THAT(FileBytes(folder_ / "s.ply"), HasSubstr("element vertex 3\n"));
  EXPECT_EQ(json::parse(FileBytes(folder_ / "s.json")), answer["samples"]);
}

TEST_F(PointQuestionsTest, LinesRunStraightOn) {
  const json answer =
      GeodesicJson({"trace", grid_, "-s", "40", "-d", "1,2,0", "-d", "0,-1,0",
                    "--length", "0.3", "-o", folder_ / "l.obj", "-o",
                    folder_ / "l.json", "-o", folder_ / "l.png"});
  ASSERT_EQ(answer["lines"].size(), 2);
  const double norm = std::sqrt(5);
  const json& end = answer["lines"][0]["positions"].back();
  EXPECT_NEAR(end[0], At(40)[0] + 0.3 / norm, kTolerance);
  EXPECT_NEAR(end[1], At(40)[1] + 0.6 / norm, kTolerance);
  EXPECT_EQ(answer["lines"][0]["end"], "length");
  EXPECT_THAT(FileBytes(folder_ / "l.obj"), HasSubstr("\nl "));
  const json towards =
      GeodesicJson({"trace", grid_, "-s", "40", "--towards", "41"});
  EXPECT_EQ(towards["lines"][0]["end"], "boundary");
  EXPECT_NEAR(towards["lines"][0]["length"], 1 - At(40)[0], kTolerance);
}

TEST_F(PointQuestionsTest, LogMapKeepsDistances) {
  const json answer =
      GeodesicJson({"logmap", grid_, "-s", "40", "-o", folder_ / "u.csv", "-o",
                    folder_ / "u.npy", "-o", folder_ / "u.ply"});
  EXPECT_EQ(answer["mapped_vertices"], vertex_count_);
  const std::vector<std::vector<double>> rows =
      Rows(FileBytes(folder_ / "u.csv"));
  ASSERT_EQ(rows.size(), vertex_count_);
  for (const std::vector<double>& a : rows) {
    for (const std::vector<double>& b : rows) {
      EXPECT_NEAR(
          std::hypot(a[1] - b[1], a[2] - b[2]),
          Euclid(At(static_cast<size_t>(a[0])), At(static_cast<size_t>(b[0]))),
          1e-9);
    }
  }
  EXPECT_THAT(FileBytes(folder_ / "u.npy"), HasSubstr("'shape': (81, 2), }"));
}

}  // namespace
}  // namespace geodesic::client
