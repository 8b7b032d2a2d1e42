// A real server on a free loopback port, and stubs to talk to it.

#ifndef GEODESIC_TESTS_RPC_RPC_FIXTURE_H_
#define GEODESIC_TESTS_RPC_RPC_FIXTURE_H_

#include <google/protobuf/descriptor.h>
#include <google/rpc/error_details.pb.h>
#include <google/rpc/status.pb.h>
#include <grpcpp/channel.h>
#include <grpcpp/client_context.h>
#include <grpcpp/support/status.h>
#include <gtest/gtest.h>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/computation.h"
#include "geodesic/triangle_soup.h"
#include "geodesic/v1/mesh_service.grpc.pb.h"
#include "geodesic/v1/question_service.grpc.pb.h"
#include "server/server.h"
#include "tests/rpc/reply.h"

namespace geodesic::server::test {

// A computation that does what another does, which is made by the time that it
// is asked.
class WrappedComputation : public Computation {
 public:
  DistanceField Field() const override { return computation_->Field(); }
  absl::Status AddSource(const Source& source) override {
    return computation_->AddSource(source);
  }
  uint64_t bytes() const override { return computation_->bytes(); }

 protected:
  std::unique_ptr<Computation> computation_;
};

// Holds computations up until it lets go; until then they poll, as a solver in
// a long computation would.
class HeldSolver {
 public:
  // Returns when it has let go, or with what the checkpoint says.
  absl::Status Hold(const Mesh& mesh, Checkpoint& checkpoint);

  void LetGo();

  // Returns when `count` computations have begun.
  void WaitForStarts(int count);

  // Computations that have begun.
  int starts();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool held_ = true;
  int starts_ = 0;
};

// Adds the token, if there is one, to a call.
void AddToken(const std::string& token, grpc::ClientContext& context);

// A question under way.
struct OpenCall {
  grpc::ClientContext context;
  std::unique_ptr<AnswerReader> reader;
  v1::Answer message;  // that was read last

  // Whether there was one more message.
  bool Read() { return reader->Read(&message); }
  // Reads to the end.
  grpc::Status End();
};

class RpcTest : public ::testing::Test {
 protected:
  ~RpcTest() override;

  static ServerOptions SmallServer();

  // Starts the server; once a test. `held` makes it wait in `solver_`.
  void Start(const ServerOptions& options = SmallServer(), bool held = false);
  // The same with solvers of the test's own.
  void StartWith(const ServerOptions& options, StartFunction start);

  // Streams `bytes` in chunks.
  grpc::Status Upload(const v1::UploadHeader& header, const std::string& bytes,
                      v1::CreateMeshResponse& response,
                      const std::string& token = "");
  // Uploads as arrays; returns the digest.
  std::string Upload(const TriangleSoup& soup, const std::string& token = "");

  // What the server says of a mesh.
  grpc::Status GetMesh(const std::string& digest, v1::Mesh& mesh);
  grpc::Status DeleteMesh(const std::string& digest);

  static v1::ComputeFieldRequest FieldRequest(const std::string& digest,
                                              uint64_t vertex);
  // Begins a call, and reads nothing.
  template <typename Request>
  std::unique_ptr<OpenCall> Open(const Request& request,
                                 const std::string& token = "") {
    auto call = std::make_unique<OpenCall>();
    AddToken(token, call->context);
    call->reader = Begin(request, call->context);
    return call;
  }
  std::unique_ptr<OpenCall> Open(const std::string& digest, uint64_t vertex) {
    return Open(FieldRequest(digest, vertex));
  }
  // Calls and reads to the end; what came keeps the rules.
  template <typename Request>
  Reply Ask(const Request& request, grpc::ClientContext& context) {
    Reply reply = ReadAll(*Begin(request, context));
    ExpectRules(reply, request.resumption());
    return reply;
  }
  template <typename Request>
  Reply Ask(const Request& request) {
    grpc::ClientContext context;
    return Ask(request, context);
  }
  Reply Ask(const std::string& digest, uint64_t vertex) {
    return Ask(FieldRequest(digest, vertex));
  }

  // Another connection to this port of the machine, on which no more of an
  // answer comes than is read.
  static std::shared_ptr<grpc::Channel> SlowChannel(int port);

  HeldSolver solver_;
  std::unique_ptr<Server> server_;
  std::shared_ptr<grpc::Channel> channel_;
  std::unique_ptr<v1::MeshService::Stub> meshes_;
  std::unique_ptr<v1::QuestionService::Stub> questions_;

 private:
  // Calls the method that takes such a request.
  template <typename Request>
  std::unique_ptr<AnswerReader> Begin(const Request& request,
                                      grpc::ClientContext& context) {
    using Stub = v1::QuestionService::Stub;
    using Method = std::unique_ptr<AnswerReader> (Stub::*)(grpc::ClientContext*,
                                                           const Request&);
    constexpr std::tuple kMethods(
        &Stub::ComputeField, &Stub::ComputePaths, &Stub::ComputePairs,
        &Stub::ComputeMatrix, &Stub::FindNearest, &Stub::ComputeIsolines,
        &Stub::SampleFarthestPoints, &Stub::ComputeLogMap, &Stub::TraceLines);
    return std::invoke(std::get<Method>(kMethods), *questions_, &context,
                       request);
  }
};

// The header of an upload of these arrays.
v1::UploadHeader ArraysHeader(const TriangleSoup& soup);

// The payload under which errors carry their serialized google.rpc.Status.
inline constexpr char kDetails[] = "test/grpc-status-details-bin";

// What goes beside the messages of a call, by name.
using Metadata = std::multimap<std::string, std::string>;

// All methods of the contract.
std::vector<const google::protobuf::MethodDescriptor*> AllMethods();

// "/geodesic.v1.Service/Method".
std::string PathOf(const google::protobuf::MethodDescriptor& method);

// Sends one serialized message to `method` ("/package.Service/Method"), for
// which there need be no stub, and returns the one that comes back.
absl::StatusOr<std::string> CallMethod(
    const std::shared_ptr<grpc::Channel>& channel, const std::string& method,
    const std::string& request, const Metadata& metadata = {});

// The rich error in a status.
google::rpc::Status Details(const grpc::Status& status);

template <typename Message>
std::optional<Message> Detail(const grpc::Status& status) {
  const google::rpc::Status details = Details(status);
  for (const auto& any : details.details()) {
    Message message;
    if (any.UnpackTo(&message)) return message;
  }
  return std::nullopt;
}

// The reason in its ErrorInfo, or "".
std::string Reason(const grpc::Status& status);

// The field that the BadRequest of a status names, or "".
std::string FieldAtFault(const grpc::Status& status);

// The RetryInfo of a status.
std::optional<google::rpc::RetryInfo> RetryInfo(const grpc::Status& status);

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_RPC_RPC_FIXTURE_H_
