// Places that are written by what they are near to, through the command.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/integration/planar_grid_test.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr int kFile = 3;

// The grid is the unit square.
class PlacesTest : public PlanarGridTest {};

TEST_F(PlacesTest, AnswersAreThoseOfThePlacesTheyBecome) {
  const json field =
      GeodesicJson({"field", grid_, "-s", "nearest: 0.3, -2, 5", "-s",
                    "max:y:0.5", "--curve", "min:x;1", "-t", "max:x"});
  const json& sources = field["sources"];
  EXPECT_EQ(sources[0]["edge"], json({2, 3}));
  EXPECT_NEAR(sources[0]["t"], 0.4, kTolerance);
  EXPECT_EQ(sources[1], json({{"vertex", 72}, {"offset", 0.5}}));
  EXPECT_EQ(sources[2]["curve"], json({{{"vertex", 0}}, {{"vertex", 1}}}));
  EXPECT_EQ(field["targets"][0]["vertex"], 8);
  EXPECT_NEAR(field["targets"][0]["distance"], 0.7, kTolerance);
}

// The same with a digest as with the file; and where the source is one.
TEST_F(PlacesTest, DigestsAndLogMapsTakeThem) {
  const std::string near = "nearest:0.5,0.5,-1";
  const std::string middle = std::to_string(kMiddle);
  for (const char* question : {"field", "logmap"}) {
    EXPECT_EQ(GeodesicJson({question, digest_, "-s", near})["sources"],
              GeodesicJson({question, grid_, "-s", middle})["sources"]);
  }
  // Text shows what was found.
  EXPECT_THAT(Geodesic({"matrix", grid_, "-s", near, "-t", "min:y"}).out,
              HasSubstr("\n" + middle + ",0,0.707106781186547"));
}

TEST_F(PlacesTest, DistancesOfPairs) {
  const json one =
      GeodesicJson({"distance", grid_, "nearest:0.3,-2,5", "max:x"});
  EXPECT_NEAR(one["distance"], 0.7, kTolerance);
  EXPECT_EQ(one["source"]["edge"], json({2, 3}));
  EXPECT_EQ(one["target"]["vertex"], 8);
  WriteFile(folder_ / "p.txt", "nearest:0.25, -1, 0 max:x\n0,nearest:0,9,0\n");
  WriteFile(folder_ / "found.txt", "2 8\n0 72\n");
  const auto answer = [this](const std::string& list) {
    return Geodesic({"distance", grid_, "--pairs", folder_ / list}).out;
  };
  EXPECT_THAT(answer("p.txt"), HasSubstr("\n2,8,"));
  EXPECT_EQ(answer("p.txt"), answer("found.txt"));
}

TEST_F(PlacesTest, ListsHoldThem) {
  WriteFile(folder_ / "s.txt", "min:x\nnearest:1, -1, 0\n");
  const json matrix =
      GeodesicJson({"matrix", grid_, "--sources", folder_ / "s.txt",
                    "--targets", folder_ / "s.txt"});
  EXPECT_EQ(matrix["sources"][1]["vertex"], 8);
  EXPECT_EQ(matrix["finite_values"], 4);
  WriteFile(folder_ / "s.txt", "0\nnearest:1,2\n");
  EXPECT_THAT(
      Refusal({"matrix", grid_, "--sources", folder_ / "s.txt"}, kFile),
      HasSubstr("s.txt line 2: 'nearest:1,2' is not a source: nearest needs "
                "three coordinates"));
}

TEST_F(PlacesTest, InfoSaysWhereToBegin) {
  MeshArrays beam = mesh_;
  for (Point& position : beam.positions) position[1] = 4 * position[1] - 3;
  const std::string path = folder_ / "beam.off";
  WriteFile(path, OffText(beam));
  const json info = GeodesicJson({"info", path});
  EXPECT_EQ(info["bounding_box_min"][1], -3);
  EXPECT_EQ(info["bounding_box_max"][1], 1);
  EXPECT_EQ(info["bounding_box_size"][0], 1);
  EXPECT_EQ(info["bounding_box_size"][1], 4);
  const std::string text = Geodesic({"info", path}).out;
  EXPECT_THAT(text, HasSubstr("--source max:y "));
  EXPECT_EQ(GeodesicJson(
                {"field", path, "--source", "max:y"})["sources"][0]["vertex"],
            72);
}

}  // namespace
}  // namespace geodesic::client
