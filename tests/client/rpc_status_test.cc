#include "client/src/rpc_status.h"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>

#include "geodesic_client/errors.h"
#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"

namespace geodesic::client {
namespace {

// A status with one detail.
template <typename Detail>
grpc::Status Rich(grpc::StatusCode code, const std::string& message,
                  const Detail& detail) {
  google::rpc::Status rich;
  rich.add_details()->PackFrom(detail);
  return {code, message, rich.SerializeAsString()};
}

TEST(RpcStatusTest, KeepsCodeAndMessage) {
  EXPECT_TRUE(FromRpcStatus(grpc::Status::OK).ok());
  EXPECT_EQ(FromRpcStatus({grpc::StatusCode::NOT_FOUND, "no such mesh"}),
            absl::NotFoundError("no such mesh"));
}

TEST(RpcStatusTest, NamesTheFieldsAtFault) {
  google::rpc::BadRequest bad_request;
  auto* same = bad_request.add_field_violations();
  same->set_field("sources[0].vertex");
  same->set_description("source 9 is out of range");
  auto* other = bad_request.add_field_violations();
  other->set_field("mesh_digest");
  other->set_description("too short");
  const absl::Status status =
      FromRpcStatus(Rich(grpc::StatusCode::INVALID_ARGUMENT,
                         "source 9 is out of range", bad_request));
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_EQ(status.message(),
            "source 9 is out of range [field sources[0].vertex; field "
            "mesh_digest: too short]");
}

TEST(RpcStatusTest, NamesTheFileInsteadOfFields) {
  google::rpc::BadRequest bad_request;
  bad_request.add_field_violations()->set_field("chunk.data");
  EXPECT_EQ(FromRpcStatus(Rich(grpc::StatusCode::INVALID_ARGUMENT,
                               "line 3: oops", bad_request),
                          "a.off")
                .message(),
            "a.off: line 3: oops");
  EXPECT_EQ(
      FromRpcStatus({grpc::StatusCode::UNAVAILABLE, "away"}, "a.off").message(),
      "away");
}

TEST(RpcStatusTest, SaysWhenToTryAgain) {
  google::rpc::RetryInfo retry;
  retry.mutable_retry_delay()->set_seconds(1);
  retry.mutable_retry_delay()->set_nanos(500'000'000);
  const absl::Status status =
      FromRpcStatus(Rich(grpc::StatusCode::RESOURCE_EXHAUSTED, "busy", retry));
  EXPECT_TRUE(absl::IsResourceExhausted(status));
  EXPECT_EQ(status.message(), "busy [try again in 1.5 s]");
  EXPECT_EQ(RetryDelay(status), std::chrono::duration<double>(1.5));
  EXPECT_EQ(ErrorReason(status), "");
}

TEST(RpcStatusTest, TheReasonCanBeRead) {
  google::rpc::ErrorInfo info;
  info.set_reason("MESH_NOT_RESIDENT");
  const absl::Status status =
      FromRpcStatus(Rich(grpc::StatusCode::NOT_FOUND, "gone", info));
  EXPECT_EQ(status.message(), "gone");
  EXPECT_EQ(ErrorReason(status), "MESH_NOT_RESIDENT");
  EXPECT_EQ(RetryDelay(status), std::nullopt);
  EXPECT_EQ(ErrorReason(absl::OkStatus()), "");
}

TEST(RpcStatusTest, IgnoresDetailsItCannotRead) {
  EXPECT_EQ(FromRpcStatus({grpc::StatusCode::INTERNAL, "oops", "\xff\xff\xff"}),
            absl::InternalError("oops"));
}

TEST(RetryTest, OnlyWhatMayPassIsTriedAgain) {
  const std::stop_token never;
  EXPECT_FALSE(WaitToRetry(absl::InvalidArgumentError("no"), 1, never));
  // A limit: no word of when to come again.
  EXPECT_FALSE(WaitToRetry(absl::ResourceExhaustedError("no"), 1, never));
  EXPECT_TRUE(WaitToRetry(absl::UnavailableError("later"), 1, never));
}

TEST(RetryTest, NotForEver) {
  EXPECT_FALSE(
      WaitToRetry(absl::UnavailableError("later"), 4, std::stop_token()));
}

TEST(RetryTest, ARequestToStopEndsTheWait) {
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(
      WaitToRetry(absl::UnavailableError("later"), 1, source.get_token()));
}

}  // namespace
}  // namespace geodesic::client
