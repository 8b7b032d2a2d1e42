#include "tests/rpc/rpc_fixture.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/support/byte_buffer.h>
#include <spdlog/sinks/null_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <utility>

#include "absl/strings/cord.h"
#include "absl/strings/str_cat.h"
#include "tests/engine/uploads.h"

namespace geodesic::server::test {
namespace {

constexpr size_t kChunkBytes = 256 << 10;

// A computation that is held up before it advances.
class HeldComputation final : public WrappedComputation {
 public:
  HeldComputation(HeldSolver& solver, const Mesh& mesh,
                  std::unique_ptr<Computation> computation)
      : solver_(solver), mesh_(mesh) {
    computation_ = std::move(computation);
  }

  absl::Status Advance(const Reach& reach, Checkpoint& checkpoint) override {
    absl::Status status = solver_.Hold(mesh_, checkpoint);
    if (!status.ok()) return status;
    return computation_->Advance(reach, checkpoint);
  }

 private:
  HeldSolver& solver_;
  const Mesh& mesh_;
};

}  // namespace

absl::Status HeldSolver::Hold(const Mesh& mesh, Checkpoint& checkpoint) {
  std::unique_lock lock(mutex_);
  ++starts_;
  changed_.notify_all();
  while (held_) {
    lock.unlock();
    absl::Status status =
        checkpoint.Poll({.vertices = mesh.vertex_count(), .live_windows = 1});
    if (!status.ok()) return status;
    lock.lock();
    changed_.wait_for(lock, std::chrono::milliseconds(1),
                      [this] { return !held_; });
  }
  return absl::OkStatus();
}

void HeldSolver::LetGo() {
  std::lock_guard lock(mutex_);
  held_ = false;
  changed_.notify_all();
}

int HeldSolver::starts() {
  std::lock_guard lock(mutex_);
  return starts_;
}

void HeldSolver::WaitForStarts(int count) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return starts_ >= count; });
}

grpc::Status OpenCall::End() {
  while (Read()) {
  }
  return reader->Finish();
}

RpcTest::~RpcTest() {
  solver_.LetGo();
  server_.reset();
}

ServerOptions RpcTest::SmallServer() {
  constexpr uint64_t kMiB = uint64_t{1} << 20;
  return {.listen = "127.0.0.1:0",
          .max_message_bytes = 2 * kMiB,
          .limits = {.max_upload_bytes = 64 * kMiB,
                     .max_vertices = 2'000'000,
                     .max_faces = 1'000'000,
                     .max_sources = 10,
                     .max_curve_points = 10,
                     .max_targets = 100,
                     .max_levels = 5,
                     .max_samples = 20,
                     .max_pairs = 3000,
                     .max_matrix_rows = 200,
                     .max_matrix_values = 1'000'000,
                     .max_concurrent_jobs = 2,
                     .max_queued_jobs = 2,
                     .mesh_store_bytes = 512 * kMiB,
                     .field_cache_bytes = 64 * kMiB,
                     .upload_memory_bytes = 1024 * kMiB,
                     .solver_memory_bytes = 1024 * kMiB,
                     .progress_interval = std::chrono::milliseconds(5)}};
}

void RpcTest::Start(const ServerOptions& options, bool held) {
  StartFunction start = &StartComputation;
  if (held) {
    start = [this](const Mesh& mesh, const ValidQuery& query,
                   const SolveOptions& solve_options)
        -> absl::StatusOr<std::unique_ptr<Computation>> {
      auto computation = StartComputation(mesh, query, solve_options);
      if (!computation.ok()) return computation.status();
      return std::make_unique<HeldComputation>(solver_, mesh,
                                               *std::move(computation));
    };
  }
  StartWith(options, std::move(start));
}

void RpcTest::StartWith(const ServerOptions& options, StartFunction start) {
  const auto logger = std::make_shared<spdlog::logger>(
      "test", std::make_shared<spdlog::sinks::null_sink_mt>());
  server_ = std::make_unique<Server>(options, logger, std::move(start));
  const absl::Status status = server_->Start();
  ASSERT_TRUE(status.ok()) << status;
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(-1);
  channel_ =
      grpc::CreateCustomChannel(absl::StrCat("127.0.0.1:", server_->port()),
                                grpc::InsecureChannelCredentials(), arguments);
  meshes_ = v1::MeshService::NewStub(channel_);
  questions_ = v1::QuestionService::NewStub(channel_);
}

grpc::Status RpcTest::Upload(const v1::UploadHeader& header,
                             const std::string& bytes,
                             v1::CreateMeshResponse& response,
                             const std::string& token) {
  grpc::ClientContext context;
  AddToken(token, context);
  const auto writer = meshes_->CreateMesh(&context, &response);
  v1::CreateMeshRequest message;
  *message.mutable_header() = header;
  bool open = writer->Write(message);
  for (size_t at = 0; open && at < bytes.size(); at += kChunkBytes) {
    message.mutable_chunk()->set_offset(at);
    message.mutable_chunk()->set_data(bytes.substr(at, kChunkBytes));
    open = writer->Write(message);
  }
  writer->WritesDone();
  return writer->Finish();
}

std::string RpcTest::Upload(const TriangleSoup& soup,
                            const std::string& token) {
  v1::CreateMeshResponse response;
  const grpc::Status status =
      Upload(ArraysHeader(soup), ArrayBytes(soup), response, token);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return response.mesh().digest();
}

grpc::Status RpcTest::GetMesh(const std::string& digest, v1::Mesh& mesh) {
  grpc::ClientContext context;
  v1::GetMeshRequest request;
  request.set_digest(digest);
  v1::GetMeshResponse response;
  const grpc::Status status = meshes_->GetMesh(&context, request, &response);
  mesh = response.mesh();
  return status;
}

grpc::Status RpcTest::DeleteMesh(const std::string& digest) {
  grpc::ClientContext context;
  v1::DeleteMeshRequest request;
  request.set_digest(digest);
  v1::DeleteMeshResponse response;
  return meshes_->DeleteMesh(&context, request, &response);
}

v1::ComputeFieldRequest RpcTest::FieldRequest(const std::string& digest,
                                              uint64_t vertex) {
  v1::ComputeFieldRequest request;
  request.set_mesh_digest(digest);
  request.add_sources()->set_vertex(vertex);
  return request;
}

std::shared_ptr<grpc::Channel> RpcTest::SlowChannel(int port) {
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_HTTP2_BDP_PROBE, 0);
  arguments.SetInt(GRPC_ARG_HTTP2_STREAM_LOOKAHEAD_BYTES, 65536);
  return grpc::CreateCustomChannel(absl::StrCat("127.0.0.1:", port),
                                   grpc::InsecureChannelCredentials(),
                                   arguments);
}

void AddToken(const std::string& token, grpc::ClientContext& context) {
  if (!token.empty()) context.AddMetadata("authorization", "Bearer " + token);
}

v1::UploadHeader ArraysHeader(const TriangleSoup& soup) {
  v1::UploadHeader header;
  header.set_format(v1::MESH_FORMAT_ARRAYS);
  header.set_size_bytes(ArrayBytes(soup).size());
  header.set_vertex_count(soup.positions.size());
  header.set_face_count(soup.triangles.size());
  return header;
}

std::vector<const google::protobuf::MethodDescriptor*> AllMethods() {
  std::vector<const google::protobuf::MethodDescriptor*> methods;
  for (const char* name : {"Mesh", "Question", "Capabilities"}) {
    const auto* service =
        google::protobuf::DescriptorPool::generated_pool()->FindServiceByName(
            absl::StrCat("geodesic.v1.", name, "Service"));
    for (int i = 0; service != nullptr && i < service->method_count(); ++i) {
      methods.push_back(service->method(i));
    }
  }
  return methods;
}

std::string PathOf(const google::protobuf::MethodDescriptor& method) {
  return absl::StrCat("/", method.service()->full_name(), "/", method.name());
}

absl::StatusOr<std::string> CallMethod(
    const std::shared_ptr<grpc::Channel>& channel, const std::string& method,
    const std::string& request, const Metadata& metadata) {
  grpc::ClientContext context;
  for (const auto& [name, value] : metadata) context.AddMetadata(name, value);
  const grpc::Slice slice(request);
  const grpc::ByteBuffer sent(&slice, 1);
  grpc::ByteBuffer response;
  const auto ended = std::make_shared<std::promise<grpc::Status>>();
  grpc::GenericStub(channel).UnaryCall(
      &context, method, {}, &sent, &response,
      [ended](grpc::Status status) { ended->set_value(std::move(status)); });
  const grpc::Status status = ended->get_future().get();
  if (!status.ok()) {
    absl::Status error(static_cast<absl::StatusCode>(status.error_code()),
                       status.error_message());
    error.SetPayload(kDetails, absl::Cord(status.error_details()));
    return error;
  }
  grpc::Slice bytes;
  response.DumpToSingleSlice(&bytes);
  return std::string(reinterpret_cast<const char*>(bytes.begin()),
                     bytes.size());
}

google::rpc::Status Details(const grpc::Status& status) {
  google::rpc::Status details;
  EXPECT_TRUE(details.ParseFromString(status.error_details()));
  return details;
}

std::string Reason(const grpc::Status& status) {
  const auto info = Detail<google::rpc::ErrorInfo>(status);
  if (!info.has_value()) return "";
  EXPECT_EQ(info->domain(), "geodesic.v1");
  return info->reason();
}

std::string FieldAtFault(const grpc::Status& status) {
  const auto bad_request = Detail<google::rpc::BadRequest>(status);
  if (!bad_request || bad_request->field_violations().empty()) return "";
  EXPECT_EQ(bad_request->field_violations(0).description(),
            status.error_message());
  EXPECT_EQ(Details(status).code(), status.error_code());
  return bad_request->field_violations(0).field();
}

std::optional<google::rpc::RetryInfo> RetryInfo(const grpc::Status& status) {
  return Detail<google::rpc::RetryInfo>(status);
}

}  // namespace geodesic::server::test
