#include "server/rpc/status_translation.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "server/engine/status_details.h"
#include "tests/rpc/rpc_fixture.h"

namespace geodesic::server {
namespace {

TEST(StatusTranslation, KeepsCodeAndMessage) {
  EXPECT_TRUE(ToGrpcStatus(absl::OkStatus()).ok());
  const grpc::Status status = ToGrpcStatus(absl::NotFoundError("not here"));
  EXPECT_EQ(status.error_code(), grpc::StatusCode::NOT_FOUND);
  EXPECT_EQ(status.error_message(), "not here");
  EXPECT_EQ(status.error_details(), "");
}

TEST(StatusTranslation, AFieldAtFaultBecomesABadRequest) {
  const grpc::Status status =
      ToGrpcStatus(InvalidField("chunk.offset", "it is wrong"));
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_EQ(test::FieldAtFault(status), "chunk.offset");
}

TEST(StatusTranslation, ARetryHintBecomesRetryInfo) {
  const grpc::Status status = ToGrpcStatus(WithRetryAfter(
      absl::ResourceExhaustedError("full"), std::chrono::milliseconds(1500)));
  const auto retry = test::RetryInfo(status);
  ASSERT_TRUE(retry.has_value());
  EXPECT_EQ(retry->retry_delay().seconds(), 1);
  EXPECT_EQ(retry->retry_delay().nanos(), 500'000'000);
}

TEST(StatusTranslation, BytesOfAFileDoNotBreakTheMessage) {
  const grpc::Status status =
      ToGrpcStatus(InvalidField("chunk.data", "line 1: \"\xff\x01\""));
  EXPECT_EQ(status.error_message(), "line 1: \\\"\\xff\\x01\\\"");
  EXPECT_EQ(test::FieldAtFault(status), "chunk.data");
}

}  // namespace
}  // namespace geodesic::server
