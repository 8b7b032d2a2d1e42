// Every question, by library and by command.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "tests/integration/planar_grid_test.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// Fields: places, limits, quantities and streams.
using FieldQuestionsTest = PlanarGridTest;

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
  for (uint32_t j = 0; j <= kGrid; ++j) {
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

// Shortest paths and isolines.
using LineQuestionsTest = PlanarGridTest;

TEST_F(LineQuestionsTest, PathsAreStraightInThePlane) {
  std::vector<SurfacePoint> targets = places_;
  for (uint32_t v = 0; v < vertex_count_; v += 7) {
    targets.push_back(VertexPoint{v});
  }
  const std::vector<Source> sources = {{VertexPoint{0}, 0.25},
                                       {FacePoint{100, {0.5, 0.25, 0.25}}}};
  absl::StatusOr<PathAnswer> answer = client_.ComputePaths(
      {.mesh_digest = digest_, .sources = sources, .targets = targets});
  ASSERT_TRUE(answer.ok()) << answer.status();
  ASSERT_EQ(answer->paths.size(), targets.size());
  const std::vector<Point> from = {At(0),
                                   Where(FacePoint{100, {0.5, 0.25, 0.25}})};
  for (size_t i = 0; i < targets.size(); ++i) {
    const GeodesicPath& path = answer->paths[i];
    const Point to = Where(targets[i]);
    ASSERT_TRUE(path.source.has_value());
    const Point& start = from.at(*path.source);
    EXPECT_NEAR(path.length, Euclid(start, to), kTolerance);
    EXPECT_NEAR(path.distance, sources[*path.source].offset + path.length,
                kTolerance);
    EXPECT_LE(
        path.distance,
        std::min(0.25 + Euclid(from[0], to), Euclid(from[1], to)) + kTolerance);
    ASSERT_EQ(path.line.points.size(), path.line.positions.size());
    EXPECT_LT(Euclid(path.line.positions.front(), start), kTolerance);
    EXPECT_LT(Euclid(path.line.positions.back(), to), kTolerance);
    double length = 0;
    for (size_t k = 0; k < path.line.points.size(); ++k) {
      EXPECT_LT(Euclid(path.line.positions[k], Where(path.line.points[k])),
                kTolerance);
      if (k > 0) {
        length += Euclid(path.line.positions[k - 1], path.line.positions[k]);
      }
    }
    // As long as the straight line between its ends: it is that line.
    EXPECT_NEAR(length, path.length, kTolerance);
  }
}

TEST_F(LineQuestionsTest, PathsThatDoNotExistAreEmpty) {
  absl::StatusOr<PathAnswer> answer = client_.ComputePaths(
      {.mesh_digest = digest_,
       .sources = {{VertexPoint{0}}},
       .targets = {VertexPoint{kVertices - 1}, VertexPoint{0}, VertexPoint{1}},
       .radius = 0.5});
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_FALSE(answer->paths[0].source.has_value());
  EXPECT_EQ(answer->paths[0].distance, kInfinity);
  EXPECT_TRUE(answer->paths[0].line.points.empty());
  EXPECT_EQ(answer->paths[1].length, 0);
  EXPECT_EQ(answer->paths[1].line.points.size(), 1);
  EXPECT_NEAR(answer->paths[2].length, 1.0 / kGrid, kTolerance);
}

TEST_F(LineQuestionsTest, IsolinesAreCircles) {
  // Around the middle: closed below 0.5, cut by the sides above. The answer is
  // in order of level, each once.
  const std::vector<double> levels = {0.6, 0.2, 0.45, 0.2};
  absl::StatusOr<IsolineAnswer> answer =
      client_.ComputeIsolines({.mesh_digest = digest_,
                               .sources = {{VertexPoint{kMiddle}}},
                               .levels = levels});
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_TRUE(std::ranges::is_sorted(answer->isolines, {}, &Isoline::level));
  std::map<double, int> closed;
  std::map<double, int> open;
  for (const Isoline& isoline : answer->isolines) {
    ++(isoline.is_closed ? closed : open)[isoline.level];
    EXPECT_GT(isoline.line.points.size(), 2);
    for (size_t i = 0; i < isoline.line.points.size(); ++i) {
      EXPECT_NEAR(Euclid(isoline.line.positions[i], At(kMiddle)), isoline.level,
                  kTolerance);
      EXPECT_LT(
          Euclid(isoline.line.positions[i], Where(isoline.line.points[i])),
          kTolerance);
    }
  }
  EXPECT_EQ(closed, (std::map<double, int>{{0.2, 1}, {0.45, 1}}));
  EXPECT_EQ(open, (std::map<double, int>{{0.6, 4}}));
}

TEST_F(LineQuestionsTest, PathIsStraight) {
  const json answer = GeodesicJson({"path",   grid_,
                                    "-s",     "0",
                                    "-t",     "79",
                                    "-t",     "0",
                                    "-o",     folder_ / "p.obj",
                                    "-o",     folder_ / "p.ply",
                                    "-o",     folder_ / "p.vtk",
                                    "-o",     folder_ / "p.csv",
                                    "-o",     folder_ / "p.json",
                                    "-o",     folder_ / "p.png",
                                    "--size", "320x240"});
  const json& path = answer["paths"][0];
  EXPECT_EQ(path["source"], 0);
  EXPECT_NEAR(path["length"], Euclid(At(0), At(79)), kTolerance);
  for (const json& p : path["positions"]) {
    // On the line from (0, 0) to (7/8, 1).
    EXPECT_NEAR(p[0].get<double>(), 7.0 / 8 * p[1].get<double>(), kTolerance);
  }
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

// Farthest-point samples and log maps.
using PointQuestionsTest = PlanarGridTest;

TEST_F(PointQuestionsTest, LogMapOfThePlaneKeepsAllDistances) {
  const std::vector<SurfacePoint> places = {
      VertexPoint{kMiddle}, EdgePoint{kMiddle, kMiddle + 1, 0.4},
      FacePoint{101, {0.3, 0.3, 0.4}}};
  for (const SurfacePoint& place : places) {
    absl::StatusOr<LogMap> map =
        client_.ComputeLogMap({.mesh_digest = digest_, .source = place});
    ASSERT_TRUE(map.ok()) << map.status();
    ASSERT_EQ(map->coordinates.size(), vertex_count_);
    const Point from = Where(place);
    const Point& x = map->zero_direction;
    EXPECT_NEAR(Euclid(x, {0, 0, 0}), 1, kTolerance);
    for (uint64_t v = 0; v < vertex_count_; ++v) {
      // Along and to the left of the direction of angle 0.
      const double dx = At(v)[0] - from[0];
      const double dy = At(v)[1] - from[1];
      EXPECT_NEAR(map->coordinates[v][0], dx * x[0] + dy * x[1], 1e-9);
      EXPECT_NEAR(map->coordinates[v][1], dy * x[0] - dx * x[1], 1e-9);
    }
  }
  absl::StatusOr<LogMap> near = client_.ComputeLogMap(
      {.mesh_digest = digest_, .source = VertexPoint{kMiddle}, .radius = 0.2});
  ASSERT_TRUE(near.ok()) << near.status();
  EXPECT_TRUE(std::isnan(near->coordinates[0][0]));
  EXPECT_FALSE(std::isnan(near->coordinates[kMiddle + 1][0]));
}

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
