#include "client/cli/terminal/text.h"

#include <gtest/gtest.h>

#include <sstream>

namespace geodesic::client {
namespace {

TEST(TextTest, GroupedNumbers) {
  EXPECT_EQ(GroupedNumber(0), "0");
  EXPECT_EQ(GroupedNumber(999), "999");
  EXPECT_EQ(GroupedNumber(1000), "1,000");
  EXPECT_EQ(GroupedNumber(96966), "96,966");
  EXPECT_EQ(GroupedNumber(18446744073709551615U), "18,446,744,073,709,551,615");
}

TEST(TextTest, ByteCounts) {
  EXPECT_EQ(ByteCount(0), "0 B");
  EXPECT_EQ(ByteCount(1023), "1023 B");
  EXPECT_EQ(ByteCount(1536), "1.5 KiB");
  EXPECT_EQ(ByteCount(uint64_t{3} << 40), "3.0 TiB");
}

TEST(TextTest, Times) {
  EXPECT_EQ(Seconds(0.0123), "12.3 ms");
  EXPECT_EQ(Seconds(4.5678), "4.57 s");
}

TEST(TextTest, FactsLineUp) {
  std::ostringstream out;
  PrintFacts({{"a", "1"}, {"long name", "2"}}, &out);
  EXPECT_EQ(out.str(), "a          1\nlong name  2\n");
}

TEST(TextTest, TablesLineUp) {
  std::ostringstream out;
  PrintTable({"name", "n"}, {{"x", "1,000"}, {"longer", "2"}}, &out);
  EXPECT_EQ(out.str(), "name        n\nx       1,000\nlonger      2\n");
}

TEST(TextTest, ControlCharactersDoNotReachTheTerminal) {
  EXPECT_EQ(Printable("a\x1b[31m\n\x7f"), "a\\x1b[31m\\x0a\\x7f");
  // U+009B begins a command, as ESC [ does.
  EXPECT_EQ(Printable("\xc2\x9b"
                      "31m"),
            "\\x9b31m");
  EXPECT_EQ(Printable("H\xc3\xb6he \xc2\xb5m"), "H\xc3\xb6he \xc2\xb5m");
  std::ostringstream out;
  PrintFacts({{"name", "\x1b[2J"}}, &out);
  PrintTable({"h"}, {{"\x1b[2J"}}, &out);
  EXPECT_EQ(out.str().find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace geodesic::client
