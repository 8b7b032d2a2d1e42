#include "server/engine/base/status_details.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "absl/strings/str_cat.h"
#include "geodesic_types/field_path.h"
#include "tests/support/temporary_folder.h"

namespace geodesic::server {
namespace {

// What clients are told to look for must be what they get.
TEST(StatusDetails, TheProtocolListsEveryReason) {
  const std::string text = geodesic::test::FileBytes(GEODESIC_PROTOCOL_PAGE);
  for (const std::string_view reason : kErrorReasons) {
    EXPECT_THAT(text, ::testing::HasSubstr(
                          absl::StrCat("`", std::string(reason), "`")));
  }
}

TEST(StatusDetails, OkStaysOk) {
  EXPECT_TRUE(WithFieldPath(absl::OkStatus(), "a").ok());
  EXPECT_EQ(FieldPathOf(WithFieldPath(absl::OkStatus(), "a")), std::nullopt);
}

TEST(StatusDetails, MessagesArePrintable) {
  EXPECT_EQ(PrintableMessage(absl::InternalError("a \"b\" \\c")),
            "a \"b\" \\c");
  EXPECT_EQ(PrintableMessage(absl::InternalError("a\nb\xff")), "a\\nb\\xff");
}

}  // namespace
}  // namespace geodesic::server
