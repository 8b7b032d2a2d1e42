// What the client shares with the protocol: digests, names, statuses.

#include <google/protobuf/descriptor.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "client/src/rpc_status.h"
#include "geodesic/v1/capabilities_service.pb.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "geodesic/v1/question_service.pb.h"
#include "geodesic_client/errors.h"
#include "geodesic_client/field.h"
#include "geodesic_client/mesh.h"
#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"

namespace geodesic::client {
namespace {

// Computed with Python's hashlib and struct from the definition in mesh.proto.
TEST(MeshDigestTest, IsTheOneTheProtocolDefines) {
  EXPECT_EQ(MeshDigest({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}),
            "4538d0d0eb2a08471aab3a00e597e36252b1ea05f74234051eabd46ee6a8b4ba");
  EXPECT_EQ(MeshDigest({}),
            "6687583eb49f1b9c0b6274258375ab8a8e87365b820ab336b7fb2cf23264c2fc");
}

TEST(MeshDigestTest, HasTheFormOfADigest) {
  EXPECT_TRUE(IsMeshDigest(MeshDigest({})));
  EXPECT_FALSE(IsMeshDigest(""));
  EXPECT_FALSE(IsMeshDigest(std::string(64, 'G')));
  EXPECT_FALSE(IsMeshDigest(std::string(64, 'A')));
  EXPECT_FALSE(IsMeshDigest(std::string(63, 'a')));
  EXPECT_TRUE(IsMeshDigest(std::string(64, 'a')));
}

TEST(AlgorithmNamesTest, AreThoseOfTheProtocol) {
  EXPECT_EQ(AlgorithmNames(),
            (std::vector<std::string>{"fwp-list", "fwp-ch", "fwp-mmp", "ich",
                                      "mmp", "lc-ch", "lc-mmp", "ch"}));
}

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

TEST(RpcStatusTest, NoServerMakesAnybodyWaitForLong) {
  using Seconds = std::chrono::duration<double>;
  const auto delay = [](int64_t seconds) {
    google::rpc::RetryInfo retry;
    retry.mutable_retry_delay()->set_seconds(seconds);
    return DelayBeforeRetry(
        FromRpcStatus(
            Rich(grpc::StatusCode::RESOURCE_EXHAUSTED, "full", retry)),
        /*attempts=*/1);
  };
  EXPECT_GE(delay(5), Seconds(5));
  EXPECT_LE(delay(5), Seconds(6.5));
  EXPECT_EQ(delay(3600), Seconds(10));
  // Twice as long each time.
  for (int attempts = 1; attempts < kMaxAttempts; ++attempts) {
    const Seconds least(0.1 * (1 << attempts));
    const Seconds unsaid =
        DelayBeforeRetry(absl::UnavailableError("gone"), attempts);
    EXPECT_GE(unsaid, least);
    EXPECT_LE(unsaid, 1.3 * least);
  }
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

TEST(RpcStatusTest, AStreamWithoutAStatusIsABrokenConnection) {
  for (const grpc::Status& broken :
       {grpc::Status(grpc::StatusCode::UNKNOWN, "Stream removed"),
        grpc::Status(grpc::StatusCode::INTERNAL,
                     "Received RST_STREAM with error code 2")}) {
    EXPECT_EQ(FromRpcStatus(broken).code(), absl::StatusCode::kUnavailable);
  }
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
  // A server that is full says when.
  google::rpc::RetryInfo retry;
  retry.mutable_retry_delay()->set_nanos(1'000'000);
  EXPECT_TRUE(WaitToRetry(
      FromRpcStatus(Rich(grpc::StatusCode::RESOURCE_EXHAUSTED, "full", retry)),
      1, never));
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

using Json = nlohmann::json;

TEST(ServiceConfig, NamesServicesAndMethodsThatExist) {
  std::ifstream file(GEODESIC_SERVICE_CONFIG);
  ASSERT_TRUE(file) << GEODESIC_SERVICE_CONFIG;
  const Json config = Json::parse(file);
  std::map<std::string, const google::protobuf::ServiceDescriptor*> services;
  for (const auto* message : {v1::GetCapabilitiesRequest::descriptor(),
                              v1::GetMeshRequest::descriptor(),
                              v1::ComputeFieldRequest::descriptor()}) {
    const auto* service = message->file()->service(0);
    services[service->full_name()] = service;
  }
  int checked = 0;
  for (const Json& name : config["methodConfig"][0]["name"]) {
    const auto* service = services[name["service"].get<std::string>()];
    ASSERT_NE(service, nullptr) << name;
    if (name.contains("method")) {
      EXPECT_NE(service->FindMethodByName(name["method"].get<std::string>()),
                nullptr)
          << name;
    }
    ++checked;
  }
  EXPECT_EQ(checked, 6);
}

}  // namespace
}  // namespace geodesic::client
