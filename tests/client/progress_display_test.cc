#include "client/cli/terminal/progress_display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace geodesic::client {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::HasSubstr;

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

}  // namespace
}  // namespace geodesic::client
