// Fields are computed once.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/integration/meshes.h"
#include "tests/integration/running_server.h"

namespace geodesic::client {
namespace {

using nlohmann::json;

class CacheTest : public IntegrationTest {
 protected:
  void SetUp() override {
    WriteFile(folder_ / "grid.off", OffText(HillyGrid(20)));
  }
};

TEST_F(CacheTest, AnswersTheSecondTimeWithTheSameBytes) {
  const json first = GeodesicJson({"field", folder_ / "grid.off", "--source",
                                   "7", "-o", folder_ / "1.f64"});
  const json second = GeodesicJson({"field", folder_ / "grid.off", "--source",
                                    "7", "-o", folder_ / "2.f64"});
  EXPECT_EQ(first["origin"], "computed");
  EXPECT_EQ(second["origin"], "cached");
  EXPECT_EQ(second["statistics"], first["statistics"]);
  EXPECT_EQ(FileBytes(folder_ / "1.f64"), FileBytes(folder_ / "2.f64"));
}

TEST_F(CacheTest, OtherQuestionsAreSolved) {
  const std::string grid = folder_ / "grid.off";
  GeodesicJson({"field", grid, "--source", "7"});
  for (const std::vector<std::string>& other :
       std::vector<std::vector<std::string>>{
           {"--source", "8"},
           {"--source", "7:0.5"},
           {"--source", "7", "--source", "9"},
           {"--source", "7", "--algorithm", "mmp"}}) {
    std::vector<std::string> words = {"field", grid};
    words.insert(words.end(), other.begin(), other.end());
    EXPECT_EQ(GeodesicJson(words)["origin"], "computed") << other[1];
  }
}

TEST_F(CacheTest, OrderOfSourcesDoesNotMatter) {
  const std::string grid = folder_ / "grid.off";
  GeodesicJson({"field", grid, "-s", "7", "-s", "9:0.25"});
  EXPECT_EQ(GeodesicJson({"field", grid, "-s", "9:0.25", "-s", "7"})["origin"],
            "cached");
}

TEST_F(CacheTest, DeletingTheMeshForgetsItsFields) {
  const std::string grid = folder_ / "grid.off";
  GeodesicJson({"field", grid, "-s", "7"});
  GeodesicJson({"delete", grid});
  EXPECT_EQ(GeodesicJson({"field", grid, "-s", "7"})["origin"], "computed");
}

TEST_F(CacheTest, AlgorithmsAgree) {
  double expected = 0;
  for (const char* algorithm : {"fwp-list", "fwp-ch", "fwp-mmp", "ich", "mmp",
                                "ch", "lc-mmp", "lc-ch"}) {
    const json field = GeodesicJson(
        {"field", folder_ / "grid.off", "-s", "0", "--algorithm", algorithm});
    EXPECT_EQ(field["algorithm"], algorithm);
    const double largest = field["largest_distance"];
    if (expected == 0) expected = largest;
    EXPECT_NEAR(largest, expected, 1e-10 * expected) << algorithm;
  }
}

}  // namespace
}  // namespace geodesic::client
