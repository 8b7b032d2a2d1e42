#include "readers/text_scanner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace geodesic {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> Lines(std::string_view bytes) {
  std::vector<std::string> lines;
  LineScanner scanner(bytes);
  while (scanner.Next()) {
    lines.emplace_back(scanner.line());
    EXPECT_EQ(scanner.line_number(), lines.size());
  }
  EXPECT_EQ(scanner.remaining(), 0u);
  return lines;
}

TEST(LineScannerTest, EveryLineEndEndsALine) {
  EXPECT_THAT(Lines("a\nb\nc"), ElementsAre("a", "b", "c"));
  EXPECT_THAT(Lines("a\rb\rc"), ElementsAre("a", "b", "c"));
  EXPECT_THAT(Lines("a\r\nb\r\nc"), ElementsAre("a", "b", "c"));
  EXPECT_THAT(Lines("a\r\nb\rc\nd\n\re"),
              ElementsAre("a", "b", "c", "d", "", "e"));
}

TEST(LineScannerTest, TheEndOfTheLastLineIsOptional) {
  EXPECT_THAT(Lines(""), IsEmpty());
  EXPECT_THAT(Lines("\n"), ElementsAre(""));
  EXPECT_THAT(Lines("\r"), ElementsAre(""));
  EXPECT_THAT(Lines("\r\n"), ElementsAre(""));
  EXPECT_THAT(Lines("a\r"), ElementsAre("a"));
  EXPECT_THAT(Lines("a\n\n"), ElementsAre("a", ""));
}

TEST(LineScannerTest, SkipsAByteOrderMark) {
  EXPECT_THAT(Lines("\xef\xbb\xbfply\n"), ElementsAre("ply"));
  EXPECT_THAT(Lines("\xef\xbb\xbf"), IsEmpty());
}

TEST(LineScannerTest, TellsWhereTheNextLineBegins) {
  LineScanner scanner("ab\r\nc\rd\ne");
  ASSERT_TRUE(scanner.Next());
  EXPECT_EQ(scanner.line_end(), LineEnd::kCrLf);
  EXPECT_EQ(scanner.offset(), 4u);
  ASSERT_TRUE(scanner.Next());
  EXPECT_EQ(scanner.line_end(), LineEnd::kCr);
  ASSERT_TRUE(scanner.Next());
  EXPECT_EQ(scanner.line_end(), LineEnd::kLf);
  EXPECT_EQ(scanner.remaining(), 1u);
  ASSERT_TRUE(scanner.Next());
  EXPECT_EQ(scanner.line_end(), LineEnd::kNone);
  EXPECT_FALSE(scanner.Next());
}

TEST(LineScannerTest, NonBlankLinesKeepTheirNumbers) {
  LineScanner scanner("\n \t\n\nx\n  ");
  ASSERT_TRUE(scanner.NextNonBlank());
  EXPECT_EQ(scanner.line(), "x");
  EXPECT_EQ(scanner.line_number(), 4u);
  EXPECT_FALSE(scanner.NextNonBlank());
}

TEST(TakeTokenTest, BlanksSeparate) {
  std::string_view text = "  f\t1 \v 2\f";
  EXPECT_EQ(TakeToken(text), "f");
  EXPECT_EQ(TakeToken(text), "1");
  EXPECT_EQ(TakeToken(text), "2");
  EXPECT_EQ(TakeToken(text), "");
  EXPECT_EQ(TakeToken(text), "");
}

TEST(ParseFiniteTest, IsCorrectlyRounded) {
  EXPECT_EQ(ParseFinite("0.1"), 0.1);
  EXPECT_EQ(ParseFinite("1e-300"), 1e-300);
  EXPECT_EQ(ParseFinite("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(ParseFinite("2.2250738585072011e-308"), 2.2250738585072011e-308);
  EXPECT_EQ(ParseFinite("1.7976931348623157e308"),
            std::numeric_limits<double>::max());
  // Just above the midpoint of 1 and the next double, by its 800th digit.
  EXPECT_EQ(
      ParseFinite("1.00000000000000011102230246251565404236316680908203125" +
                  std::string(750, '0') + "1"),
      std::nextafter(1.0, 2.0));
}

TEST(ParseFiniteTest, TakesTheSpellingsOfExporters) {
  EXPECT_EQ(ParseFinite("+1"), 1.0);
  EXPECT_EQ(ParseFinite(".5"), 0.5);
  EXPECT_EQ(ParseFinite("-.5"), -0.5);
  EXPECT_EQ(ParseFinite("+5."), 5.0);
  EXPECT_EQ(ParseFinite("2.e+1"), 20.0);
  EXPECT_EQ(ParseFinite("1E02"), 100.0);
  EXPECT_TRUE(std::signbit(ParseFinite("-0").value()));
}

TEST(ParseFiniteTest, WhatIsTooSmallIsZeroOrSubnormal) {
  EXPECT_EQ(ParseFinite("5e-324"), 5e-324);
  EXPECT_EQ(ParseFinite("1e-400"), 0.0);
  EXPECT_EQ(ParseFinite("-1e-99999"), 0.0);
  EXPECT_EQ(ParseFinite("0e99999"), 0.0);
}

TEST(ParseFiniteTest, RefusesEverythingElse) {
  for (const char* token :
       {"",       "+",       "-",      ".",   "+-1",  "++1",      "--1",
        "1e",     "1e+",     "3.1+e2", "1,5", "1.0f", "1.0D5",    "0x10",
        "nan",    "NaN",     "-nan",   "inf", "-inf", "infinity", "1e309",
        "-1e309", "1e99999", "1 ",     " 1"}) {
    EXPECT_EQ(ParseFinite(token), std::nullopt) << token;
  }
}

TEST(ParseIntegerTest, TakesWhatFits64Bits) {
  EXPECT_EQ(ParseInteger("0"), 0);
  EXPECT_EQ(ParseInteger("+7"), 7);
  EXPECT_EQ(ParseInteger("-7"), -7);
  EXPECT_EQ(ParseInteger("9223372036854775807"),
            std::numeric_limits<int64_t>::max());
  for (const char* token : {"", "+", "-", "+-1", "1.0", "1e3", "0x1", "1/",
                            "9223372036854775808", "18446744073709551616"}) {
    EXPECT_EQ(ParseInteger(token), std::nullopt) << token;
  }
}

}  // namespace
}  // namespace geodesic
