#include "server/engine/status_details.h"

#include <gtest/gtest.h>

namespace geodesic::server {
namespace {

TEST(StatusDetails, FieldTravelsWithTheStatus) {
  const absl::Status status = InvalidField("chunk.offset", "it is wrong");
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_EQ(status.message(), "it is wrong");
  EXPECT_EQ(FieldAtFault(status), "chunk.offset");
  EXPECT_EQ(FieldAtFault(absl::InternalError("x")), std::nullopt);
}

TEST(StatusDetails, RetryTravelsWithTheStatus) {
  const absl::Status status = WithRetryAfter(
      absl::ResourceExhaustedError("full"), std::chrono::milliseconds(1500));
  EXPECT_EQ(RetryAfter(status), std::chrono::milliseconds(1500));
  EXPECT_EQ(RetryAfter(absl::ResourceExhaustedError("full")), std::nullopt);
}

TEST(StatusDetails, OkStaysOk) {
  EXPECT_TRUE(WithField(absl::OkStatus(), "a").ok());
  EXPECT_EQ(FieldAtFault(WithField(absl::OkStatus(), "a")), std::nullopt);
}

TEST(StatusDetails, MessagesArePrintable) {
  EXPECT_EQ(PrintableMessage(absl::InternalError("a \"b\" \\c")),
            "a \"b\" \\c");
  EXPECT_EQ(PrintableMessage(absl::InternalError("a\nb\xff")), "a\\nb\\xff");
}

}  // namespace
}  // namespace geodesic::server
