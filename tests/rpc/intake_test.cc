// How requests come in: who is refused before, how long it may take, what it
// may hold.

#include <gmock/gmock.h>
#include <grpcpp/client_context.h>
#include <grpcpp/completion_queue.h>
#include <grpcpp/generic/generic_stub.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "digest/sha256.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/rpc_fixture.h"
#include "tests/support/temporary_folder.h"

namespace geodesic::server {
namespace {

using ::testing::HasSubstr;

constexpr char kComputeField[] = "/geodesic.v1.QuestionService/ComputeField";

class IntakeTest : public test::RpcTest {
 protected:
  // How a call ends whose client sends headers and then nothing.
  grpc::Status CallWithoutRequest(const std::string& method) {
    grpc::ClientContext context;
    grpc::CompletionQueue queue;
    grpc::GenericStub stub(channel_);
    const auto call = stub.PrepareCall(&context, method, &queue);
    call->StartCall(nullptr);
    void* tag = nullptr;
    bool ok = false;
    queue.Next(&tag, &ok);
    grpc::Status status;
    call->Finish(&status, nullptr);
    queue.Next(&tag, &ok);
    return status;
  }

  static v1::ComputeFieldRequest WithTargets(const std::string& digest,
                                             int count) {
    v1::ComputeFieldRequest request = FieldRequest(digest, 0);
    for (int i = 0; i < count; ++i) request.add_targets()->set_vertex(i % 4);
    return request;
  }
};

TEST_F(IntakeTest, AMalformedRequestIsSaidToBeOne) {
  Start();
  for (const auto* method : test::AllMethods()) {
    const auto answer =
        test::CallMethod(channel_, test::PathOf(*method), "\xff");
    ASSERT_TRUE(absl::IsInvalidArgument(answer.status()))
        << method->full_name() << ": " << answer.status();
    EXPECT_THAT(std::string(answer.status().message()),
                AllOf(HasSubstr(method->input_type()->full_name()),
                      HasSubstr("compressed by neither gzip nor deflate")));
  }
}

TEST_F(IntakeTest, AMessageThatDoesNotComeIsNotWaitedForForEver) {
  ServerOptions options = SmallServer();
  options.receive_patience = std::chrono::seconds(1);
  Start(options);
  for (const char* method :
       {kComputeField, "/geodesic.v1.MeshService/CreateMesh",
        "/geodesic.v1.MeshService/GetMesh"}) {
    const grpc::Status status = CallWithoutRequest(method);
    EXPECT_EQ(status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED)
        << method << ": " << status.error_message();
    EXPECT_THAT(status.error_message(), HasSubstr("receive-seconds"));
  }
}

TEST_F(IntakeTest, WhoHasNoTokenIsRefusedBeforeTheRequestComes) {
  const geodesic::test::TemporaryFolder folder;
  ServerOptions options = SmallServer();
  options.token_file = folder / "tokens.json";
  std::ofstream(options.token_file)
      << R"({"tokens": [{"name": "a", "scopes": ["read"], "sha256": ")"
      << Sha256Hex("token") << R"("}]})";
  Start(options);
  EXPECT_EQ(CallWithoutRequest(kComputeField).error_code(),
            grpc::StatusCode::UNAUTHENTICATED);
}

TEST_F(IntakeTest, ARequestThatCanNeverBeHeldIsRefusedForGood) {
  ServerOptions options = SmallServer();
  options.request_memory_bytes = 64 << 10;
  Start(options);
  const std::string digest = Upload(test::Tetrahedron());
  const grpc::Status status = Ask(WithTargets(digest, 1000)).status;
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_THAT(status.error_message(), HasSubstr("--limit request-memory"));
  EXPECT_FALSE(test::RetryInfo(status).has_value());
  // A smaller one is not.
  EXPECT_TRUE(Ask(digest, 0).status.ok());
}

TEST_F(IntakeTest, WhatRequestsHoldIsBounded) {
  ServerOptions options = SmallServer();
  options.request_memory_bytes = 4 << 20;
  options.limits.max_targets = 10'000;
  Start(options, /*held=*/true);
  const std::string digest = Upload(test::Tetrahedron());
  const v1::ComputeFieldRequest request = WithTargets(digest, 10'000);
  std::vector<std::unique_ptr<test::OpenCall>> held;
  grpc::Status refusal;
  // More than 40 bytes a target: they cannot be a hundred.
  while (held.size() < 100 && refusal.ok()) {
    auto call = Open(request);
    if (call->Read()) {
      held.push_back(std::move(call));
    } else {
      refusal = call->reader->Finish();
    }
  }
  // Once it is asked, a request holds half.
  const std::string refused = refusal.error_message();
  const uint64_t needed = std::stoull(refused.substr(0, refused.find(' ')));
  EXPECT_GT(held.size() * needed, options.request_memory_bytes);
  EXPECT_EQ(refusal.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(test::Reason(refusal), "MEMORY_FULL");
  EXPECT_THAT(refusal.error_message(), HasSubstr("--limit request-memory"));
  EXPECT_TRUE(test::RetryInfo(refusal).has_value());

  solver_.LetGo();
  for (const auto& call : held) EXPECT_TRUE(call->End().ok());
  held.clear();
  // A client hears the end of a call before the server has let go of it.
  test::Reply reply;
  do {
    reply = Ask(request);
  } while (test::Reason(reply.status) == "MEMORY_FULL");
  EXPECT_TRUE(reply.status.ok()) << reply.status.error_message();
}

}  // namespace
}  // namespace geodesic::server
