// Every question, asked wrongly: the command names what is wrong and says what
// would be right.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/integration/planar_grid_test.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

using Words = std::vector<std::string>;

// A question, complete but for the mesh and the sources.
struct Question {
  std::string name;
  Words words;
  bool has_targets = false;
  bool has_radius = false;
  bool has_curves = true;
};

const std::vector<Question>& Questions() {
  static const auto& questions = *new std::vector<Question>{
      {"field", {}, true, true},
      {"path", {"-t", "3"}, true, true},
      {"isolines", {"-l", "0.3"}},
      {"matrix", {}, true, true},
      {"nearest", {"-t", "3"}, true, true},
      {"sample", {"-n", "2"}},
      {"logmap", {}, false, true, false},
  };
  return questions;
}

// A wrong text and what is said of it, besides the text itself.
struct WrongText {
  std::string text;
  std::string says;
  std::string way_out;
  int exit_code;
};

constexpr int kUsage = 2;
constexpr int kFile = 3;
constexpr int kNoPath = 4;
constexpr int kRefused = 5;

class WrongArgumentsTest : public PlanarGridTest {
 protected:
  // The grid has 81 vertices and 128 faces.
  const std::vector<WrongText> wrong_points_ = {
      {"81", "vertex 81 is out of range", "81 vertices, numbered from 0",
       kRefused},
      {"face:128@1,0,0", "face 128 is out of range",
       "128 faces, numbered from 0", kRefused},
      {"edge:0-81@0.5", "edge.to 81 is out of range", "81 vertices", kRefused},
      {"edge:0-80@0.5", "no edge between vertices 0 and 80",
       "name two corners of one face", kRefused},
      {"face:9@0.5,0.5,0.5", "weights sum to 1.5, not to 1",
       "divide each by their sum", kRefused},
      {"face:9@1.5,-0.5,0", "the weight '-0.5' is below 0, outside the face",
       "face:F@W0,W1,W2", kUsage},
      {"face:9@nan,0,1", "the weight 'nan' is not a number", "weights >= 0",
       kUsage},
      {"face:9@1,0", "three weights", "face:F@W0,W1,W2", kUsage},
      {"face:x@1,0,0", "'x' is not a face's number", "face:F@W0,W1,W2", kUsage},
      {"edge:0-1@1.5", "T is '1.5', not a number from 0 to 1", "edge:A-B@T",
       kUsage},
      {"edge:0-1@nan", "T is 'nan'", "T from 0 to 1", kUsage},
      {"edge:0-1", "an edge needs A-B and @T", "edge:A-B@T", kUsage},
      {"here", "'here' is not a vertex's number", "VERTEX", kUsage},
      {"-1", "'-1' is not a vertex's number", "numbers from 0", kUsage},
      {"", "''", "VERTEX", kUsage}};

  // The words of a question about the grid.
  Words Ask(const Question& question, Words more = {}) const {
    more.insert(more.begin(), {question.name, grid_});
    more.insert(more.end(), question.words.begin(), question.words.end());
    return more;
  }

  void ExpectNamed(const Words& words, const WrongText& wrong) const {
    SCOPED_TRACE(::testing::PrintToString(words));
    EXPECT_THAT(Refusal(words, wrong.exit_code),
                AllOf(HasSubstr("geodesic: "), HasSubstr(wrong.says),
                      HasSubstr(wrong.way_out)));
  }
};

TEST_F(WrongArgumentsTest, Sources) {
  for (const Question& question : Questions()) {
    for (const WrongText& wrong : wrong_points_) {
      ExpectNamed(Ask(question, {"-s", wrong.text}), wrong);
    }
  }
}

TEST_F(WrongArgumentsTest, Targets) {
  for (const Question& question : Questions()) {
    for (const WrongText& wrong : wrong_points_) {
      if (!question.has_targets) continue;
      // What no mesh has is refused by the same code for all.
      if (wrong.exit_code == kUsage && question.name != "path") continue;
      ExpectNamed(Ask(question, {"-s", "0", "-t", wrong.text}), wrong);
    }
  }
}

TEST_F(WrongArgumentsTest, TheOneAtFaultIsNumbered) {
  for (const Question& question : Questions()) {
    if (question.name != "logmap") {
      ExpectNamed(
          Ask(question, {"-s", "0", "-s", "99"}),
          {"", "sources[1].vertex 99", "[field sources[1].vertex]", kRefused});
      ExpectNamed(Ask(question, {"-s", "0", "-s", "edge:0-80@0"}),
                  {"", "sources[1].edge", "[field sources[1].edge]", kRefused});
    }
    if (!question.has_targets || !question.words.empty()) continue;
    ExpectNamed(Ask(question, {"-s", "0", "-t", "1", "-t", "99"}),
                {"", "targets[1].vertex 99", "targets[1]", kRefused});
  }
}

TEST_F(WrongArgumentsTest, Offsets) {
  for (const Question& question : Questions()) {
    if (question.name == "logmap") {
      ExpectNamed(Ask(question, {"-s", "0:0.5"}),
                  {"", "'0:0.5' is not a point", "VERTEX", kUsage});
      continue;
    }
    for (const std::string offset : {"nan", "-1", "inf", "x", ""}) {
      ExpectNamed(Ask(question, {"-s", "0:" + offset}),
                  {"", "the offset '" + offset + "' is not a number >= 0",
                   ":OFFSET >= 0", kUsage});
    }
  }
}

TEST_F(WrongArgumentsTest, Curves) {
  for (const Question& question : Questions()) {
    if (!question.has_curves) continue;
    ExpectNamed(Ask(question, {"--curve", "0;80"}),
                {"", "sources[0].curve.points[0] and [1] lie in no common face",
                 "add the points where the curve crosses edges", kRefused});
    ExpectNamed(Ask(question, {"--curve", "0;1;"}),
                {"", "'0;1;' is not a curve", "POINT;POINT;...", kUsage});
    ExpectNamed(Ask(question, {"--curve", "0;1:-2"}),
                {"", "the offset '-2'", ":OFFSET", kUsage});
  }
}

TEST_F(WrongArgumentsTest, Radii) {
  for (const Question& question : Questions()) {
    for (const std::string radius : {"nan", "-1", "far"}) {
      ExpectNamed(
          Ask(question, {"-s", "0", "--radius=" + radius}),
          question.has_radius
              ? WrongText{"", "'" + radius + "' is not a radius",
                          "a number >= 0", kUsage}
              : WrongText{"", "not expected here: --radius=" + radius,
                          "geodesic " + question.name + " --help", kUsage});
    }
  }
}

TEST_F(WrongArgumentsTest, CountsAndLevels) {
  const std::vector<std::pair<Words, WrongText>> table = {
      {{"nearest", grid_, "-s", "0", "-t", "1", "-k", "0"},
       {"", "'0' is not a count", "a whole number from 1", kUsage}},
      {{"sample", grid_, "-n", "0"},
       {"", "'0' is not a count", "a whole number from 1", kUsage}},
      {{"isolines", grid_, "-s", "0", "-n", "0"},
       {"", "'0' is not a count", "a whole number from 1", kUsage}},
      {{"isolines", grid_, "-s", "0", "-n", "1000000"},
       {"", "--count 1000000 is more than the 1000 levels", "max_levels",
        kRefused}},
      {{"isolines", grid_, "-s", "0", "-l", "0"},
       {"", "'0' is not a level", "a distance above 0", kUsage}},
      {{"isolines", grid_, "-s", "0", "-l", "nan"},
       {"", "'nan' is not a level", "a distance above 0", kUsage}},
      {{"isolines", grid_, "-s", "0", "-l", "1", "--chord-error", "0"},
       {"", "'0' is not a chord error", "a length above 0", kUsage}},
      {{"isolines", grid_, "-s", "0"}, {"", "--level", "--count", kUsage}},
      {{"isolines", grid_, "-s", "0", "-l", "1", "-n", "2"},
       {"", "--level", "--count", kUsage}},
      {{"field", grid_, "-s", "0", "--stop-at-targets"},
       {"", "--stop-at-targets", "needs --target or --targets", kUsage}},
      {{"logmap", grid_, "-s", "0", "-s", "1"},
       {"", "--source", "a log map has one source", kUsage}},
  };
  for (const auto& [words, wrong] : table) ExpectNamed(words, wrong);
}

TEST_F(WrongArgumentsTest, Nothing) {
  WriteFile(folder_ / "empty.txt", "# nobody\n");
  for (const Question& question : Questions()) {
    ExpectNamed({question.name}, {"", "MESH is required", "--help", kUsage});
    if (question.name != "sample") {
      ExpectNamed(Ask(question), {"", "--source", "is required", kUsage});
    }
    if (question.has_curves) {
      ExpectNamed(Ask(question, {"--sources", folder_ / "empty.txt"}),
                  {"", "empty.txt lists nothing", "one place a line", kFile});
    }
    if (!question.has_targets) continue;
    // Without the target of its own.
    ExpectNamed(
        {question.name, grid_, "-s", "0", "--targets", folder_ / "empty.txt"},
        {"", "empty.txt lists nothing", "one place a line", kFile});
    if (question.words.empty()) continue;
    ExpectNamed({question.name, grid_, "-s", "0"},
                {"", "--target (or --targets FILE)", "required", kUsage});
  }
}

TEST_F(WrongArgumentsTest, Outputs) {
  for (const Question& question : Questions()) {
    ExpectNamed(
        Ask(question, {"-s", "0", "-o", "answer.xyz"}),
        {"", "answer.xyz", "the endings this command knows are .", kUsage});
    const std::string ending = question.name == "path" ? ".obj" : ".csv";
    ExpectNamed(
        Ask(question, {"-s", "0", "-o", folder_ / ("none/answer" + ending)}),
        {"", "none/answer" + ending, "which must exist", kFile});
    std::filesystem::create_directory(folder_ / ("folder" + ending));
    ExpectNamed(Ask(question, {"-s", "0", "-o", folder_ / ("folder" + ending)}),
                {"", "folder" + ending, "it is a folder", kFile});
  }
}

TEST_F(WrongArgumentsTest, AlgorithmsAndMeshes) {
  for (const Question& question : Questions()) {
    ExpectNamed(Ask(question, {"-s", "0", "-a", "dijkstra"}),
                {"", "dijkstra", "fwp-mmp", kUsage});
    Words words = Ask(question, {"-s", "0"});
    words[1] = folder_ / "missing.off";
    ExpectNamed(words,
                {"", "missing.off", "neither a file nor a digest", kFile});
    words[1] = std::string(64, 'a');
    ExpectNamed(words, {"", std::string(64, 'a'), "geodesic upload", kRefused});
  }
}

// What looks wrong and is not: all else is at infinity.
TEST_F(WrongArgumentsTest, SourceOnAnIsolatedVertex) {
  MeshArrays alone = mesh_;
  alone.positions.push_back({9, 9, 9});
  const std::string path = folder_ / "alone.off";
  WriteFile(path, OffText(alone));
  const json field = GeodesicJson({"field", path, "-s", "81:0.5"});
  EXPECT_EQ(field["unreachable_vertices"], 81);
  EXPECT_EQ(field["farthest_vertex"], 81);
  EXPECT_EQ(field["largest_distance"], 0.5);
  const json paths =
      GeodesicJson({"path", path, "-s", "81", "-t", "0"}, kNoPath)["paths"];
  EXPECT_TRUE(paths[0]["distance"].is_null());
  EXPECT_EQ(GeodesicJson({"isolines", path, "-s", "81", "-l",
                          "1"})["levels"][0]["lines"],
            0);
  EXPECT_EQ(GeodesicJson({"matrix", path, "-s", "81"})["finite_values"], 1);
  EXPECT_EQ(GeodesicJson({"nearest", path, "-s", "81", "-t",
                          "0"})["found"][0]["nearest"],
            json::array());
  EXPECT_TRUE(GeodesicJson({"sample", path, "-s", "81", "-n",
                            "1"})["samples"][0]["distance"]
                  .is_null());
  // No direction leads away from it.
  EXPECT_THAT(Refusal({"logmap", path, "-s", "81"}, kRefused),
              AllOf(HasSubstr("source vertex 81 belongs to no face"),
                    HasSubstr("name a point of a face")));
}

}  // namespace
}  // namespace geodesic::client
