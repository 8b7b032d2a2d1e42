#include "client/cli/arguments/pair_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/client/temporary_folder.h"

namespace geodesic::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

WrittenPair Vertices(uint32_t source, uint32_t target) {
  return {VertexPoint{source}, VertexPoint{target}};
}

TEST(ParsePairTest, TakesBlanksTabsAndCommas) {
  for (const char* text :
       {"3 4", "3,4", "3\t4", " 3  ,  4 ", "3, 4\r", "3 ,4"}) {
    const auto pair = ParsePair(text);
    ASSERT_TRUE(pair.ok()) << text << pair.status();
    EXPECT_EQ(*pair, Vertices(3, 4)) << text;
  }
}

TEST(ParsePairTest, CommasOfWeightsBelongToTheFace) {
  const FacePoint face{5, {0.2, 0.3, 0.5}};
  for (const char* text : {"face:5@0.2,0.3,0.5,17", "face:5@0.2,0.3,0.5 17",
                           "face:5@0.2,0.3,0.5, 17"}) {
    const auto pair = ParsePair(text);
    ASSERT_TRUE(pair.ok()) << text << pair.status();
    EXPECT_EQ(*pair, (WrittenPair{face, VertexPoint{17}})) << text;
  }
  EXPECT_EQ(*ParsePair("edge:3-8@0.25,face:5@0.2,0.3,0.5"),
            (WrittenPair{EdgePoint{3, 8, 0.25}, face}));
}

TEST(ParsePairTest, CoordinatesMayHaveBlanks) {
  const NearestPoint near{{1, -2, 0.5}};
  for (const char* text :
       {"nearest:1,-2,0.5 max:z", "nearest:1,-2,0.5,max:z",
        "nearest: 1, -2, 0.5 , max:z", "nearest:1,\t-2,0.5\tmax:z"}) {
    const auto pair = ParsePair(text);
    ASSERT_TRUE(pair.ok()) << text << pair.status();
    EXPECT_EQ(*pair, (WrittenPair{near, ExtremeVertex{2, true}})) << text;
  }
  EXPECT_EQ(*ParsePair("3 nearest:1, -2, 0.5"),
            (WrittenPair{VertexPoint{3}, near}));
}

TEST(ParsePairTest, NamesWhatIsWrong) {
  for (const auto& [text, says] :
       std::vector<std::pair<const char*, const char*>>{
           {"3", "'3' is one place; write two"},
           {"3,", "is one place"},
           {"3 4 5", "'5' follows the two places"},
           {"3 x", "'x' is not a point"},
           {"3,,4", "'' is not a point"},
           {"face:5@0.2,0.3 17", "'face:5@0.2,0.3' is not a point"}}) {
    const absl::Status status = ParsePair(text).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << text;
    EXPECT_THAT(std::string(status.message()), HasSubstr(says));
  }
}

TEST(PairListTest, ReadsPieceByPiece) {
  const TemporaryFolder folder;
  WriteFile(folder / "p.txt", "# pairs\n0 1\n\n2 3\n \t\n \t# more\n4 5");
  auto list = PairList::Open(folder / "p.txt");
  ASSERT_TRUE(list.ok()) << list.status();
  const auto first = list->Read(2);
  ASSERT_TRUE(first.ok()) << first.status();
  EXPECT_THAT(first->pairs, ElementsAre(Vertices(0, 1), Vertices(2, 3)));
  EXPECT_THAT(first->lines, ElementsAre(2, 4));
  const auto second = list->Read(2);
  ASSERT_TRUE(second.ok()) << second.status();
  EXPECT_THAT(second->pairs, ElementsAre(Vertices(4, 5)));
  EXPECT_THAT(second->lines, ElementsAre(7));
  EXPECT_THAT(list->Read(2)->pairs, IsEmpty());
}

TEST(PairListTest, MayBeginWithAByteOrderMark) {
  const TemporaryFolder folder;
  WriteFile(folder / "p.csv",
            "\xef\xbb\xbf"
            "0,1\r\n2,3\r\n");
  auto list = PairList::Open(folder / "p.csv");
  ASSERT_TRUE(list.ok()) << list.status();
  const auto piece = list->Read(9);
  ASSERT_TRUE(piece.ok()) << piece.status();
  EXPECT_THAT(piece->pairs, ElementsAre(Vertices(0, 1), Vertices(2, 3)));
}

TEST(PairListTest, MayBeginWithTheNamesOfItsColumns) {
  const TemporaryFolder folder;
  for (const std::string header :
       {"source,target", "# all\nSource\tTarget", "\n source , target \r"}) {
    WriteFile(folder / "p.csv", header + "\n1,2\n3,4\n");
    absl::StatusOr<PairList> list = PairList::Open(folder / "p.csv");
    ASSERT_TRUE(list.ok()) << list.status();
    const absl::StatusOr<PairList::Piece> piece = list->Read(10);
    ASSERT_TRUE(piece.ok()) << piece.status();
    EXPECT_THAT(piece->pairs, ElementsAre(Vertices(1, 2), Vertices(3, 4)));
  }
  // Nowhere else.
  for (const std::string text :
       {"1,2\nsource,target\n", "source,target\nsource,target\n",
        "source,target,distance\n1,2\n", "source\n1,2\n"}) {
    WriteFile(folder / "p.csv", text);
    absl::StatusOr<PairList> list = PairList::Open(folder / "p.csv");
    ASSERT_TRUE(list.ok()) << list.status();
    EXPECT_TRUE(absl::IsInvalidArgument(list->Read(10).status())) << text;
  }
}

TEST(PairListTest, ALineHasABound) {
  auto list = PairList::Open("/dev/zero");
  ASSERT_TRUE(list.ok()) << list.status();
  EXPECT_THAT(std::string(list->Read(9).status().message()),
              HasSubstr("/dev/zero line 1: the line has more than 4096"));
}

TEST(PairListTest, AFolderIsNoFile) {
  const TemporaryFolder folder;
  auto list = PairList::Open(folder / "");
  EXPECT_FALSE(list.ok() && list->Read(9).ok());
}

}  // namespace
}  // namespace geodesic::client
