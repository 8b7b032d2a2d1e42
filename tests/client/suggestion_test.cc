#include "client/cli/arguments/suggestion.h"

#include <gtest/gtest.h>

namespace geodesic::client {
namespace {

TEST(SuggestionTest, IsWhatTakesFewestLetters) {
  const std::vector<std::string> commands = {"field", "path", "info",
                                             "isolines"};
  EXPECT_EQ(Suggestion("field", commands), "field");
  EXPECT_EQ(Suggestion("fild", commands), "field");
  EXPECT_EQ(Suggestion("feild", commands), "field");
  EXPECT_EQ(Suggestion("izolines", commands), "isolines");
  EXPECT_EQ(Suggestion("pathh", commands), "path");
  EXPECT_EQ(Suggestion("explode", commands), "");
  EXPECT_EQ(Suggestion("", commands), "");
}

}  // namespace
}  // namespace geodesic::client
