// What the command says where an answer is less than was wanted.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "absl/strings/str_cat.h"
#include "tests/integration/meshes.h"
#include "tests/integration/running_server.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// Three squares of vertices 0 to 3, 4 to 7 and 8 to 11. The second lies beside
// the first and shares no vertex with it: 4 lies where 1 does, and 6 where 3
// does. Vertex 12 is on no face.
class UnreachedTest : public IntegrationTest {
 protected:
  void SetUp() override {
    const MeshArrays square = PlanarGrid(1);
    MeshArrays mesh;
    for (const double x : {0, 1, 5}) {
      const auto first = static_cast<uint32_t>(mesh.positions.size());
      for (const Point& p : square.positions) {
        mesh.positions.push_back({p[0] + x, p[1], p[2]});
      }
      for (const Triangle& t : square.triangles) {
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      }
    }
    mesh.positions.push_back({7, 7, 7});
    WriteFile(mesh_, OffText(mesh));
  }

  // As they are: the edge that two of them share would be joined.
  ProcessResult Geodesic(std::vector<std::string> arguments) {
    arguments.push_back("--no-weld");
    return IntegrationTest::Geodesic(arguments);
  }
  json GeodesicJson(std::vector<std::string> arguments, int exit_code = 0) {
    arguments.push_back("--no-weld");
    return IntegrationTest::GeodesicJson(arguments, exit_code);
  }

  const std::string mesh_ = folder_ / "mesh.off";
};

constexpr char kNoFace[] = "vertex 12 is on no face: nothing else";
constexpr char kSeam[] =
    "it lies in another component of the mesh; it touches others at 2 points, "
    "where vertices lie twice (4 and 1, say)";

TEST_F(UnreachedTest, PairsWithoutAPathAreTold) {
  const std::string pairs = folder_ / "pairs.txt";
  WriteFile(pairs, "0 3\n0 6\n8 0\n");
  const std::string note = absl::StrCat(
      "no path joins 2 of the pairs, the first of them 0 and 6: ", kSeam);
  const json answer = GeodesicJson({"distance", mesh_, "--pairs", pairs});
  EXPECT_THAT(answer["notes"].at(0).get<std::string>(), HasSubstr(note));
  EXPECT_THAT(answer["distances"],
              ElementsAre(json(std::sqrt(2.0)), json(), json()));
  const ProcessResult text = Geodesic({"distance", mesh_, "--pairs", pairs});
  EXPECT_THAT(text.err, HasSubstr(note));
  // A file of paths lacks two.
  const std::string lines = folder_ / "lines.obj";
  const ProcessResult paths =
      Geodesic({"distance", mesh_, "--pairs", pairs, "-o", lines});
  EXPECT_EQ(paths.exit_code, 4);
  EXPECT_THAT(paths.err, HasSubstr("no path for some of the pairs"));
  EXPECT_TRUE(std::filesystem::exists(lines));
}

TEST_F(UnreachedTest, LevelsWithoutLinesAreTold) {
  const json answer =
      GeodesicJson({"isolines", mesh_, "-s", "0", "-l", "0.5", "-l", "50"});
  EXPECT_EQ(answer["notes"].at(0), "no line is 50 away from the sources");
}

TEST_F(UnreachedTest, ASourceOnNoFaceIsTold) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{
           {"field", mesh_, "-s", "12"},
           {"field", mesh_, "-s", "0", "--curve", "12"},
           {"isolines", mesh_, "-s", "0", "-s", "12", "-l", "0.5"},
           {"nearest", mesh_, "-s", "12", "-t", "0"},
           {"sample", mesh_, "-s", "12", "-n", "2"}}) {
    EXPECT_THAT(Geodesic(words).out, HasSubstr(kNoFace)) << words[0];
    const json answer = GeodesicJson(words);
    EXPECT_THAT(answer["notes"].at(0).get<std::string>(), HasSubstr(kNoFace))
        << words[0];
  }
  // Where no summary is printed.
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{
           {"field", mesh_, "-s", "12", "--quiet", "-o", folder_ / "d.npy"},
           {"field", mesh_, "-s", "12", "--progressive"},
           {"matrix", mesh_, "-s", "12", "-t", "0"}}) {
    const ProcessResult result = Geodesic(words);
    EXPECT_EQ(result.exit_code, 0) << words[0];
    EXPECT_THAT(result.err, HasSubstr(kNoFace)) << words[0];
  }
  EXPECT_THAT(GeodesicJson({"field", mesh_, "-s", "0"})["notes"],
              ElementsAre(HasSubstr("boundary edges lie within 0")));
  EXPECT_THAT(Geodesic({"isolines", mesh_, "-s", "12", "-n", "3"}).err,
              HasSubstr(kNoFace));
}

TEST_F(UnreachedTest, APathThatIsNotThereHasACodeAndNoFile) {
  const std::string file = folder_ / "p.obj";
  for (const auto& [target, more, why] : std::vector<
           std::tuple<std::string, std::vector<std::string>, std::string>>{
           {"5", {}, kSeam},
           {"9", {}, "it lies in another component of the mesh\n"},
           {"12", {}, "vertex 12 is on no face"},
           {"3", {"-r", "0.5"}, "it is farther than the radius, 0.5"}}) {
    std::vector<std::string> words = {"path", mesh_,  "-s", "0",
                                      "-t",   target, "-o", file};
    words.insert(words.end(), more.begin(), more.end());
    const ProcessResult result = Geodesic(words);
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_THAT(result.out, HasSubstr("not reached"));
    EXPECT_THAT(result.err,
                HasSubstr("no path leads to " + target + ": " + why));
    EXPECT_FALSE(std::filesystem::exists(file));
  }
  // What is there is written.
  const json some = GeodesicJson(
      {"path", mesh_, "-s", "0", "-t", "3", "-t", "9", "-t", "12", "-o", file},
      4);
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_EQ(some["error"]["exit_code"], 4);
  EXPECT_THAT(some["error"]["message"].get<std::string>(),
              AllOf(HasSubstr("no path leads to 9"),
                    HasSubstr("nor to 1 other target")));
  EXPECT_TRUE(some["paths"][0]["unreached"].is_null());
  EXPECT_EQ(some["paths"][2]["unreached"], "vertex 12 is on no face");
  EXPECT_TRUE(some["paths"][2]["distance"].is_null());
}

TEST_F(UnreachedTest, ADistanceMayBeInfiniteAndSaysWhy) {
  const ProcessResult words = Geodesic({"distance", mesh_, "0", "5"});
  EXPECT_EQ(words.exit_code, 0);
  EXPECT_THAT(words.out, AllOf(HasSubstr("inf"), HasSubstr(kSeam)));
  const json pair = GeodesicJson({"distance", mesh_, "0", "5"});
  EXPECT_TRUE(pair["distance"].is_null());
  EXPECT_TRUE(pair["largest_distance"].is_null());
  EXPECT_THAT(pair["unreached"].get<std::string>(), HasSubstr(kSeam));
  EXPECT_TRUE(
      GeodesicJson({"distance", mesh_, "0", "3"})["unreached"].is_null());
  const std::string file = folder_ / "p.obj";
  EXPECT_EQ(Geodesic({"distance", mesh_, "0", "5", "-o", file}).exit_code, 4);
  EXPECT_FALSE(std::filesystem::exists(file));

  const std::vector<std::string> field = {"field", mesh_, "-s", "0",
                                          "-t",    "12",  "-t", "1"};
  EXPECT_THAT(Geodesic(field).out, HasSubstr("inf: vertex 12 is on no face"));
  const json targets = GeodesicJson(field)["targets"];
  EXPECT_EQ(targets[0]["unreached"], "vertex 12 is on no face");
  EXPECT_TRUE(targets[1]["unreached"].is_null());
}

TEST_F(UnreachedTest, WithoutAnyDistanceThereIsNoLargest) {
  const std::vector<std::string> field = {
      "field", mesh_, "-s", "face:0@0.2,0.3,0.5", "-r", "1e-6"};
  const json answer = GeodesicJson(field);
  EXPECT_TRUE(answer["largest_distance"].is_null());
  EXPECT_TRUE(answer["farthest_vertex"].is_null());
  EXPECT_THAT(Geodesic(field).out, HasSubstr("largest distance  none"));
  EXPECT_TRUE(
      GeodesicJson({"matrix", mesh_, "-s", "0", "-t", "9"})["largest_distance"]
          .is_null());
}

TEST_F(UnreachedTest, FewerThanWereAskedForAreTold) {
  // Eleven vertices of faces are left beside the source.
  const std::vector<std::string> sample = {"sample", mesh_, "-s",
                                           "0",      "-n",  "100"};
  EXPECT_THAT(Geodesic(sample).out,
              HasSubstr("100 samples were asked for and 11 are there"));
  const json answer = GeodesicJson(sample);
  EXPECT_EQ(answer["samples"].size(), 11);
  // And the edge that is not joined.
  EXPECT_EQ(answer["notes"].size(), 2);
  const json nearest = GeodesicJson(
      {"nearest", mesh_, "-s", "0", "-t", "1", "-t", "9", "-k", "3"});
  ASSERT_EQ(nearest["notes"].size(), 3);
  EXPECT_THAT(nearest["notes"][0].get<std::string>(),
              HasSubstr("3 nearest targets were asked for, and there are 2"));
  EXPECT_THAT(nearest["notes"][1].get<std::string>(),
              HasSubstr("1 source has fewer than 2 targets"));
}

TEST_F(UnreachedTest, CurvesTellTheirLength) {
  // Along two sides of the square.
  const std::vector<std::string> words = {"field", mesh_, "--curve", "0;1;3"};
  EXPECT_THAT(Geodesic(words).out, HasSubstr("3 points, length 2\n"));
  EXPECT_EQ(GeodesicJson(words)["sources"][0]["length"], 2);
}

}  // namespace
}  // namespace geodesic::client
