// What people and scripts see: exit codes, explanations, progress, tables.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "client/cli/terminal/exit_code.h"
#include "client/cli/terminal/progress_display.h"
#include "client/cli/terminal/text.h"

namespace geodesic::client {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::HasSubstr;

// A server, or a proxy, may end a call when it stops.
TEST(ExitCodeTest, AServersCancellationIsNoInterruption) {
  const absl::Status status = absl::CancelledError("going down");
  EXPECT_EQ(ExitCodeOf(status), ExitCode::kNoServer);
  EXPECT_EQ(Explain(status, "host:1"),
            "the server at host:1 ended the call: going down; try again in a "
            "moment");
}

TEST(ExplainTest, KeepsTheServersWordsAndSaysWhatToDo) {
  const std::vector<std::pair<absl::Status, std::string>> table = {
      {absl::UnavailableError("failed to connect to all addresses"),
       "cannot reach a server at host:1: start one with geodesicd, or name one "
       "with --server"},
      {absl::UnavailableError("shutting down"),
       "the server at host:1 is not available: shutting down; try again in a "
       "moment"},
      {absl::NotFoundError("mesh ab is not resident"),
       "mesh ab is not resident; `geodesic meshes` lists what is resident, "
       "`geodesic upload FILE` adds to it"},
      {absl::ResourceExhaustedError("Received message larger than max (9 vs. "
                                    "4)"),
       "the request is larger than the server's max_message_bytes (Received "
       "message larger than max (9 vs. 4)): ask for fewer sources, targets or "
       "levels at a time"},
      {absl::InvalidArgumentError("line 3: no number"), "line 3: no number"}};
  for (const auto& [status, said] : table) {
    EXPECT_EQ(Explain(status, "host:1"), said);
  }
}

constexpr ProgressDisplay::TimePoint kStart{};

TEST(BarLineTest, FillsWithTheFraction) {
  EXPECT_EQ(BarLine("solving", 0, "", 34),
            "solving   0% [>                  ]");
  EXPECT_EQ(BarLine("solving", 0.5, "", 34),
            "solving  50% [==========>        ]");
  EXPECT_EQ(BarLine("solving", 1, "", 34),
            "solving 100% [===================]");
}

TEST(BarLineTest, NeverWiderThanAsked) {
  for (int width = 0; width < 120; ++width) {
    for (const double fraction : {0.0, 0.333, 1.0}) {
      EXPECT_LE(BarLine("solving", fraction, "settled to 0.25", width).size(),
                static_cast<size_t>(width));
    }
  }
}

TEST(BarLineTest, DetailGivesWayToTheBar) {
  EXPECT_THAT(BarLine("solving", 0.1, "detail", 60), HasSubstr("] detail"));
  EXPECT_EQ(BarLine("solving", 0.1, "detail", 30).find("detail"),
            std::string::npos);
}

TEST(BarLineTest, OddFractionsAreClamped) {
  EXPECT_EQ(BarLine("x", std::nan(""), "", 40), BarLine("x", 0, "", 40));
  EXPECT_EQ(BarLine("x", -1, "", 40), BarLine("x", 0, "", 40));
  EXPECT_EQ(BarLine("x", 7, "", 40), BarLine("x", 1, "", 40));
}

TEST(ProgressDisplayTest, ShortWorkAndQuietCommandsLeaveNoTrace) {
  using Style = ProgressDisplay::Style;
  for (const auto& [style, after] : {std::pair{Style::kBar, milliseconds(499)},
                                     {Style::kNone, milliseconds(100'000)}}) {
    std::ostringstream out;
    {
      ProgressDisplay display(style, 60, kStart, &out);
      display.Update(kStart + after, "solving", 0.9, "");
    }
    EXPECT_EQ(out.str(), "");
  }
}

TEST(ProgressDisplayTest, BarIsRedrawnTenTimesASecondAtMostAndWiped) {
  std::ostringstream out;
  {
    ProgressDisplay display(ProgressDisplay::Style::kBar, 60, kStart, &out);
    for (int ms = 500; ms < 1500; ms += 10) {
      display.Update(kStart + milliseconds(ms), "solving", ms / 1500.0, "");
    }
  }
  const std::string text = out.str();
  EXPECT_EQ(std::ranges::count(text, '['), 10 + 11);  // Bars and wipes.
  EXPECT_TRUE(text.ends_with("\r\x1b[K"));
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(ProgressDisplayTest, LinesComeLessAndLessOften) {
  std::ostringstream out;
  ProgressDisplay display(ProgressDisplay::Style::kLines, 60, kStart, &out);
  for (int s = 0; s <= 20; ++s) {
    display.Update(kStart + seconds(s), "solving", s / 20.0, "more");
  }
  EXPECT_EQ(out.str(),
            "solving   5% after 1 s, more\n"
            "solving  30% after 6 s, more\n"
            "solving  70% after 14 s, more\n");
}

TEST(TextTest, NumbersAsPeopleReadThem) {
  EXPECT_EQ(GroupedNumber(0), "0");
  EXPECT_EQ(GroupedNumber(999), "999");
  EXPECT_EQ(GroupedNumber(1000), "1,000");
  EXPECT_EQ(GroupedNumber(96966), "96,966");
  EXPECT_EQ(GroupedNumber(18446744073709551615U), "18,446,744,073,709,551,615");
  EXPECT_EQ(ByteCount(0), "0 B");
  EXPECT_EQ(ByteCount(1023), "1023 B");
  EXPECT_EQ(ByteCount(1536), "1.5 KiB");
  EXPECT_EQ(ByteCount(uint64_t{3} << 40), "3.0 TiB");
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
