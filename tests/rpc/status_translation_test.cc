#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "geodesic_types/field_path.h"
#include "server/engine/base/argument_checks.h"
#include "server/engine/base/status_details.h"
#include "server/rpc/messages/grpc_status.h"
#include "tests/rpc/rpc_fixture.h"

namespace geodesic::server {
namespace {

TEST(StatusTranslation, KeepsCodeAndMessage) {
  EXPECT_TRUE(ToGrpcStatus(absl::OkStatus()).ok());
  const grpc::Status status = ToGrpcStatus(absl::NotFoundError("not here"));
  EXPECT_EQ(status.error_code(), grpc::StatusCode::NOT_FOUND);
  EXPECT_EQ(status.error_message(), "not here");
  EXPECT_EQ(test::Reason(status), "MESH_NOT_RESIDENT");
}

TEST(StatusTranslation, EveryErrorHasAReasonFromTheList) {
  for (int code = 1; code <= 16; ++code) {
    const grpc::Status status =
        ToGrpcStatus(absl::Status(static_cast<absl::StatusCode>(code), "no"));
    EXPECT_NE(test::Reason(status), "") << code;
  }
  EXPECT_EQ(test::Reason(ToGrpcStatus(WithReason(
                absl::ResourceExhaustedError("full"), reason::kQueueFull))),
            "QUEUE_FULL");
}

TEST(StatusTranslation, AMissingMeshIsAResource) {
  const auto resource = test::Detail<google::rpc::ResourceInfo>(
      ToGrpcStatus(NotResident(std::string(64, 'a'))));
  ASSERT_TRUE(resource.has_value());
  EXPECT_EQ(resource->resource_type(), "geodesic.v1.Mesh");
  EXPECT_EQ(resource->resource_name(), std::string(64, 'a'));
}

TEST(StatusTranslation, AQuotaNamesItsSubject) {
  const grpc::Status status = ToGrpcStatus(
      WithQuotaFailure(absl::ResourceExhaustedError("no more"), "client:ci"));
  const auto quota = test::Detail<google::rpc::QuotaFailure>(status);
  ASSERT_TRUE(quota.has_value());
  ASSERT_EQ(quota->violations_size(), 1);
  EXPECT_EQ(quota->violations(0).subject(), "client:ci");
  EXPECT_EQ(test::Reason(status), "QUOTA_EXCEEDED");
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
