#include "client/output/place_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "client/places/place_finder.h"
#include "tests/client/temporary_folder.h"

namespace geodesic::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

WrittenSource At(const WrittenPoint& point, double offset = 0) {
  return {{point}, false, offset};
}

TEST(ParsePointTest, KnowsPlacesToLookFor) {
  for (const char* text :
       {"nearest:1,-2.5,3e-4", "nearest: 1 , -2.5,\t3e-4 "}) {
    EXPECT_EQ(*ParsePoint(text), WrittenPoint(NearestPoint{{1, -2.5, 3e-4}}))
        << text;
  }
  EXPECT_EQ(*ParsePoint("min:x"), WrittenPoint(ExtremeVertex{0, false}));
  EXPECT_EQ(*ParsePoint("max:z"), WrittenPoint(ExtremeVertex{2, true}));
}

TEST(ParsePointTest, KnowsThreeKinds) {
  EXPECT_EQ(*ParsePoint("17"), WrittenPoint(VertexPoint{17}));
  EXPECT_EQ(*ParsePoint("edge:3-8@0.25"), WrittenPoint(EdgePoint{3, 8, 0.25}));
  EXPECT_EQ(*ParsePoint("face:5@0.2,0.3,0.5"),
            WrittenPoint(FacePoint{5, {0.2, 0.3, 0.5}}));
}

// What is said of others is in tests/integration/wrong_arguments_test.cc.
TEST(ParsePointTest, NamesWhatIsWrong) {
  for (const char* text : {"1.5",
                           "1:2",
                           "edge:",
                           "edge:1@0.5",
                           "edge:1-2@",
                           "edge:1-2@-0.1",
                           "face:1@1,0,0,0",
                           "face:1@inf,0,0",
                           "edge:1-2@0.5x",
                           "vertex:1",
                           "1;2",
                           "nearest:",
                           "nearest:1,2,1e999",
                           "nearest:1,,3",
                           "nearest",
                           "min:",
                           "max:",
                           "max:zz",
                           "max:Z",
                           "max:z:1",
                           "max"}) {
    const absl::Status status = ParsePoint(text).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << text;
    EXPECT_THAT(std::string(status.message()), HasSubstr("edge:A-B@T")) << text;
  }
}

TEST(ParseSourceTest, TakesAnOffset) {
  EXPECT_EQ(*ParseSource("17"), At(VertexPoint{17}, 0));
  EXPECT_EQ(*ParseSource("17:0.5"), At(VertexPoint{17}, 0.5));
  EXPECT_EQ(*ParseSource("edge:3-8@0.25:2"), At(EdgePoint{3, 8, 0.25}, 2));
  EXPECT_EQ(*ParseSource("face:5@1,0,0:1e-3"),
            At(FacePoint{5, {1, 0, 0}}, 1e-3));
  EXPECT_EQ(*ParseSource("nearest:0,0,-1:2"), At(NearestPoint{{0, 0, -1}}, 2));
  EXPECT_EQ(*ParseSource("min:y:0.5"), At(ExtremeVertex{1, false}, 0.5));
  for (const char* text : {"1:", "1:-1", "1:nan", "1:inf", "1:2:3",
                           "edge:1-2@0.5:", "edge:1-2@0.5:x", "1;2"}) {
    EXPECT_FALSE(ParseSource(text).ok()) << text;
  }
}

TEST(ParseCurveTest, IsPointsInARow) {
  EXPECT_EQ(*ParseCurve("1;edge:1-2@0.5;face:3@0,0,1:0.25"),
            (WrittenSource{
                {VertexPoint{1}, EdgePoint{1, 2, 0.5}, FacePoint{3, {0, 0, 1}}},
                true,
                0.25}));
  EXPECT_EQ(*ParseCurve("4"), (WrittenSource{{VertexPoint{4}}, true}));
  for (const char* text : {"", ";", "1;", ";1", "1;;2", "1:2;3", "1;x"}) {
    EXPECT_FALSE(ParseCurve(text).ok()) << text;
  }
}

TEST(PlaceTextTest, IsReadBack) {
  const std::vector<Source> sources = {{VertexPoint{7}, 0.1},
                                       {EdgePoint{1, 2, 1.0 / 3}, 0},
                                       {FacePoint{3, {0.1, 0.2, 0.7}}, 1e-300}};
  PlaceFinder finder(nullptr);  // there is nothing to look for
  for (const Source& source : sources) {
    EXPECT_EQ(*finder.Find(*ParseSource(SourceText(source))), source)
        << SourceText(source);
  }
  const Source curve = {Curve{{VertexPoint{7}, EdgePoint{1, 2, 0.1}}}, 2};
  EXPECT_EQ(SourceText(curve), "7;edge:1-2@0.1:2");
  EXPECT_EQ(*finder.Find(*ParseCurve(SourceText(curve))), curve);
}

TEST(PlaceTextTest, AsJson) {
  EXPECT_EQ(SourceToJson({VertexPoint{7}, 0.5}).dump(),
            R"({"vertex":7,"offset":0.5})");
  EXPECT_EQ(PointToJson(EdgePoint{1, 2, 0.5}).dump(),
            R"({"edge":[1,2],"t":0.5})");
  EXPECT_EQ(PointToJson(FacePoint{3, {0.25, 0.25, 0.5}}).dump(),
            R"({"face":3,"weights":[0.25,0.25,0.5]})");
  EXPECT_EQ(SourceToJson({Curve{{VertexPoint{1}, VertexPoint{2}}}, 0}).dump(),
            R"({"curve":[{"vertex":1},{"vertex":2}],"offset":0.0})");
}

TEST(ReadListTest, OneALine) {
  TemporaryFolder folder;
  WriteFile(folder / "s.txt",
            "# rows\n 1\n\n2:0.5\t\r\n  \n3;4\nedge:0-1@0.5\n"
            "max:z\nnearest:0, -1, 2:0.5\n");
  EXPECT_THAT(*ReadSources(folder / "s.txt"),
              ElementsAre(At(VertexPoint{1}), At(VertexPoint{2}, 0.5),
                          WrittenSource{{VertexPoint{3}, VertexPoint{4}}, true},
                          At(EdgePoint{0, 1, 0.5}), At(ExtremeVertex{2, true}),
                          At(NearestPoint{{0, -1, 2}}, 0.5)));
  WriteFile(folder / "t.txt", "5\nface:1@0,0,1\n");
  EXPECT_THAT(*ReadPoints(folder / "t.txt"),
              ElementsAre(WrittenPoint(VertexPoint{5}),
                          WrittenPoint(FacePoint{1, {0, 0, 1}})));
}

TEST(ReadListTest, MayBeginWithAByteOrderMark) {
  TemporaryFolder folder;
  WriteFile(folder / "s.txt", "\xef\xbb\xbf# rows\n1\n");
  EXPECT_THAT(*ReadSources(folder / "s.txt"), ElementsAre(At(VertexPoint{1})));
  WriteFile(folder / "names.txt", "\xef\xbb\xbftip 17\n");
  EXPECT_EQ(*ParsePoint("name:tip@" + (folder / "names.txt")),
            WrittenPoint(VertexPoint{17}));
  // Elsewhere it is none.
  WriteFile(folder / "s.txt",
            "1\n\xef\xbb\xbf"
            "2\n");
  EXPECT_TRUE(absl::IsInvalidArgument(ReadSources(folder / "s.txt").status()));
}

TEST(ReadListTest, NamesFileAndLine) {
  EXPECT_EQ(ListName("-"), "standard input");
  EXPECT_EQ(ListName("-.txt"), "-.txt");
  TemporaryFolder folder;
  WriteFile(folder / "s.txt", "1\n# fine\nx\n");
  const absl::Status status = ReadSources(folder / "s.txt").status();
  EXPECT_THAT(std::string(status.message()), HasSubstr("s.txt line 3: 'x'"));
  EXPECT_TRUE(absl::IsNotFound(ReadPoints(folder / "no.txt").status()));
}

TEST(NamedPlaceTest, FilesSayWhatNamesStandFor) {
  TemporaryFolder folder;
  const std::string path = folder / "places.txt";
  std::ofstream(path) << "# of the Horse\n\ntip 17\r\n"
                         " ear\t nearest:1, 2,3 \nmid edge:3-8@0.25\n"
                         "bad edge:3\nloop name:tip@places.txt\n";
  EXPECT_EQ(*ParsePoint("name:tip@" + path), WrittenPoint(VertexPoint{17}));
  EXPECT_EQ(*ParsePoint("name:ear@" + path),
            WrittenPoint(NearestPoint{{1, 2, 3}}));
  EXPECT_EQ(*ParseSource("name:tip@" + path + ":0.5"),
            At(VertexPoint{17}, 0.5));
  EXPECT_EQ(ParseCurve("name:tip@" + path + ";9")->points,
            (std::vector<WrittenPoint>{VertexPoint{17}, VertexPoint{9}}));

  const auto refusal = [](const std::string& text) {
    const absl::Status status = ParsePoint(text).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    return std::string(status.message());
  };
  EXPECT_THAT(refusal("name:tail@" + path),
              HasSubstr("does not list 'tail', but tip, ear, mid, bad, loop"));
  EXPECT_THAT(refusal("name:bad@" + path), HasSubstr("line 6: an edge needs"));
  EXPECT_THAT(refusal("name:loop@" + path), HasSubstr("not a name"));
  EXPECT_THAT(refusal("name:tip@" + (folder / "none")),
              HasSubstr("cannot read"));
  EXPECT_THAT(refusal("name:tip"), HasSubstr("@ and the file"));
  std::ofstream(path) << "tip 17\near 5\ntip 18\n";
  EXPECT_THAT(refusal("name:tip@" + path),
              HasSubstr("lists 'tip' twice, in lines 1 and 3"));
}

TEST(PlaceTextTest, TellsTheFilesOfNames) {
  EXPECT_THAT(FilesOfNames("17:0.5"), IsEmpty());
  EXPECT_THAT(FilesOfNames("edge:3-8@0.25"), IsEmpty());
  EXPECT_THAT(FilesOfNames("name:tip@a b.txt"),
              ElementsAre("a b.txt", "a b.txt"));
  EXPECT_THAT(FilesOfNames("name:tip@a.txt:0.5"),
              ElementsAre("a.txt:0.5", "a.txt"));
  EXPECT_THAT(FilesOfNames("3; name:x@a;name:y@b:1"),
              ElementsAre("a", "a", "b:1", "b"));
}

}  // namespace
}  // namespace geodesic::client
