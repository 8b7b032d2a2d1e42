#include "server/engine/base/status_details.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <string_view>

#include "absl/strings/str_cat.h"
#include "geodesic/field_path.h"
#include "tests/support/temporary_folder.h"

namespace geodesic::server {
namespace {

TEST(StatusDetails, FieldTravelsWithTheStatus) {
  const absl::Status status = InvalidField("chunk.offset", "it is wrong");
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_EQ(status.message(), "it is wrong");
  EXPECT_EQ(FieldPathOf(status), "chunk.offset");
  EXPECT_EQ(FieldPathOf(absl::InternalError("x")), std::nullopt);
}

TEST(StatusDetails, RetryTravelsWithTheStatus) {
  const absl::Status status = WithRetryAfter(
      absl::ResourceExhaustedError("full"), std::chrono::milliseconds(1500));
  EXPECT_EQ(RetryAfter(status), std::chrono::milliseconds(1500));
  EXPECT_EQ(RetryAfter(absl::ResourceExhaustedError("full")), std::nullopt);
}

TEST(StatusDetails, AReasonTravelsWithTheStatus) {
  const absl::Status full = absl::ResourceExhaustedError("full");
  EXPECT_EQ(ReasonOf(full), reason::kLimitExceeded);
  EXPECT_EQ(ReasonOf(WithReason(full, reason::kQueueFull)), reason::kQueueFull);
  const absl::Status quota = WithQuotaFailure(full, "client:ci");
  EXPECT_EQ(ReasonOf(quota), reason::kQuotaExceeded);
  EXPECT_EQ(QuotaSubject(quota), "client:ci");
  EXPECT_EQ(MeshAtFault(WithMesh(absl::NotFoundError("no"), "abc")), "abc");
  EXPECT_EQ(MeshAtFault(full), std::nullopt);
}

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
