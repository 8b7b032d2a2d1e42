// Every question, asked wrongly: the command names what is wrong and says what
// would be right.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/integration/planar_grid_test.h"

namespace geodesic::client {
namespace {

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
      {"", "''", "VERTEX", kUsage},
      {"nearest:1,2", "nearest needs three coordinates", "nearest:X,Y,Z",
       kUsage},
      {"nearest:a,2,nan", "the coordinate 'a' is not a finite number",
       "nearest:X,Y,Z", kUsage},
      {"nearest:1,2,3,4", "the coordinate '3,4' is not a finite number",
       "nearest:X,Y,Z", kUsage},
      {"min:w", "'w' is not an axis: x, y or z", "nearest:X,Y,Z", kUsage}};

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

TEST_F(WrongArgumentsTest, EveryText) {
  for (const WrongText& wrong : wrong_points_) {
    ExpectNamed({"field", grid_, "-s", wrong.text}, wrong);
  }
  for (const std::string offset : {"nan", "-1", "inf", "x", ""}) {
    ExpectNamed({"field", grid_, "-s", "0:" + offset},
                {"", "the offset '" + offset + "' is not a number >= 0",
                 ":OFFSET >= 0", kUsage});
  }
  for (const std::string radius : {"nan", "-1", "far"}) {
    ExpectNamed(
        {"field", grid_, "-s", "0", "--radius=" + radius},
        {"", "'" + radius + "' is not a radius", "a number >= 0", kUsage});
  }
  const std::vector<std::pair<std::string, WrongText>> curves = {
      {"0;80",
       {"", "sources[0].curve.points[0] and [1] lie in no common face",
        "add the points where the curve crosses edges", kRefused}},
      {"0;1;", {"", "'0;1;' is not a curve", "POINT;POINT;...", kUsage}},
      {"0;1:-2", {"", "the offset '-2'", ":OFFSET", kUsage}}};
  for (const auto& [curve, wrong] : curves) {
    ExpectNamed({"field", grid_, "--curve", curve}, wrong);
  }
  ExpectNamed({"distance", grid_, "0", "nearest:1,2,nan"},
              {"", "the coordinate 'nan'", "nearest:X,Y,Z", kUsage});
  ExpectNamed({"logmap", grid_, "-s", "0:0.5"},
              {"", "'0:0.5' is not a point", "VERTEX", kUsage});
}

// The texts are read alike, so one of each kind tells what a question does with
// them.
TEST_F(WrongArgumentsTest, EveryQuestion) {
  WriteFile(folder_ / "empty.txt", "# nobody\n");
  const WrongText lists_nothing = {"", "empty.txt lists nothing",
                                   "one place a line", kFile};
  for (const Question& question : Questions()) {
    ExpectNamed({question.name}, {"", "MESH is required", "--help", kUsage});
    ExpectNamed(Ask(question, {"-s", "here"}),
                {"", "'here' is not a vertex's number", "VERTEX", kUsage});
    ExpectNamed(Ask(question, {"-s", "edge:0-80@0"}),
                {"", "no edge between vertices 0 and 80",
                 "name two corners of one face", kRefused});
    ExpectNamed(Ask(question, {"-s", "0", "-a", "dijkstra"}),
                {"", "dijkstra", "fwp-mmp", kUsage});
    ExpectNamed(
        Ask(question, {"-s", "0", "-o", "answer.xyz"}),
        {"", "answer.xyz", "the endings this command knows are .", kUsage});
    ExpectNamed(
        Ask(question, {"-s", "0", "--radius=far"}),
        question.has_radius
            ? WrongText{"", "'far' is not a radius", "a number >= 0", kUsage}
            : WrongText{"", "not expected here: --radius=far",
                        "geodesic " + question.name + " --help", kUsage});
    if (question.name != "sample") {
      ExpectNamed(Ask(question), {"", "--source", "is required", kUsage});
    }
    if (question.has_curves) {
      ExpectNamed(
          Ask(question, {"-s", "0", "-s", "99"}),
          {"", "sources[1].vertex 99", "[field sources[1].vertex]", kRefused});
      ExpectNamed(Ask(question, {"--curve", "0;80"}),
                  {"", "sources[0].curve.points[0] and [1]", "crosses edges",
                   kRefused});
      ExpectNamed(Ask(question, {"--sources", folder_ / "empty.txt"}),
                  lists_nothing);
    }
    if (!question.has_targets) continue;
    ExpectNamed(Ask(question, {"-s", "0", "-t", "here"}),
                {"", "'here' is not a vertex's number", "VERTEX", kUsage});
    // Behind the target of its own, if it has one.
    ExpectNamed(Ask(question, {"-s", "0", "-t", "face:128@1,0,0"}),
                {"", "face 128 is out of range", "128 faces, numbered from 0",
                 kRefused});
    ExpectNamed({question.name, grid_, "-s", "0", "-t", "1", "-t", "99"},
                {"", "targets[1].vertex 99", "targets[1]", kRefused});
    ExpectNamed(
        {question.name, grid_, "-s", "0", "--targets", folder_ / "empty.txt"},
        lists_nothing);
    if (question.words.empty()) continue;
    ExpectNamed({question.name, grid_, "-s", "0"},
                {"", "--target (or --targets FILE)", "required", kUsage});
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

}  // namespace
}  // namespace geodesic::client
