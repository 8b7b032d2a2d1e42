#include "tests/fuzz/rpc/rpc_subject.h"

#include <google/protobuf/descriptor.h>
#include <spdlog/sinks/null_sink.h>
#include <spdlog/spdlog.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "server/engine/query_engine.h"
#include "server/operations/metrics.h"
#include "server/rpc/capabilities_service.h"
#include "server/rpc/field_service.h"
#include "server/rpc/matrix_service.h"
#include "server/rpc/mesh_service.h"
#include "server/rpc/path_service.h"
#include "server/rpc/request_log.h"
#include "server/security/access_control.h"
#include "server/security/quotas.h"
#include "tests/engine/fakes.h"
#include "tests/engine/uploads.h"
#include "tests/fuzz/rpc/answer_check.h"
#include "tests/fuzz/rpc/fake_call.h"
#include "tests/support/curved_meshes.h"

namespace geodesic::server::test {
namespace {

using geodesic::test::Terrain;
using geodesic::test::Torus;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

// More events than any script of the size that is parsed can need.
constexpr size_t kMostEvents = 1'000'000;

Limits SmallLimits() {
  Limits limits;
  limits.max_upload_bytes = 1 << 20;
  limits.max_vertices = 10'000;
  limits.max_faces = 20'000;
  limits.max_sources = 50;
  limits.max_curve_points = 50;
  limits.max_targets = 50;
  limits.max_levels = 20;
  limits.max_samples = 20;
  limits.max_matrix_rows = 40;
  limits.max_matrix_values = 1'000;
  limits.max_queued_jobs = 4;
  limits.mesh_store_bytes = 1 << 20;
  limits.field_cache_bytes = 1 << 16;
  limits.computation_store_bytes = 1 << 16;
  limits.upload_memory_bytes = 1 << 21;
  limits.solver_memory_bytes = 1 << 24;
  return limits;
}

// Three pages that meet in an edge, and on it a face without area.
TriangleSoup Book() {
  return {
      .positions =
          {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 2, 0}},
      .triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}}};
}

// Letters that stand for digests are replaced.
void SetDigests(Message& message, const std::vector<std::string>& digests) {
  const Reflection& reflection = *message.GetReflection();
  const auto* type = message.GetDescriptor();
  const auto replace = [&](std::string& text) {
    const auto number = static_cast<size_t>(text.empty() ? 0 : text[0] - 'A');
    if (text.size() == 1 && number < digests.size()) text = digests[number];
  };
  for (const char* name : {"digest", "mesh_digest"}) {
    const FieldDescriptor* field = type->FindFieldByName(name);
    if (field == nullptr) continue;
    std::string text = reflection.GetString(message, field);
    replace(text);
    reflection.SetString(&message, field, text);
  }
  const FieldDescriptor* list = type->FindFieldByName("mesh_digests");
  if (list == nullptr) return;
  for (int i = 0; i < reflection.FieldSize(message, list); ++i) {
    std::string text = reflection.GetRepeatedString(message, list, i);
    replace(text);
    reflection.SetRepeatedString(&message, list, i, text);
  }
}

class Subject {
 public:
  Subject() {
    Require(access_.Reload().ok());
    for (const TriangleSoup& soup :
         {Tetrahedron(), Terrain(5, 4, 2, 1), Torus({.around = 6, .across = 4}),
          Book()}) {
      digests_.push_back(Upload(soup));
    }
  }

  void Run(const RpcScript& script) {
    for (size_t i = 0; i < script.size(); ++i) {
      const size_t first = i;
      if (script[i].method == RpcMethod::kCreateMesh) {
        while (!script[i].ends_upload && i + 1 < script.size() &&
               script[i + 1].method == RpcMethod::kCreateMesh) {
          ++i;
        }
      }
      Begin(script, first, i + 1);
      if (!script[i].overlaps) Pump();
    }
    Pump();
    CheckNothingIsLeft();
  }

 private:
  struct Call {
    std::unique_ptr<FakeCall> call;
    std::shared_ptr<AnswerCheck> check;  // null: not a stream of answers
    size_t cancel_after = 0;
  };

  std::string Upload(const TriangleSoup& soup) {
    const std::string bytes = ArrayBytes(soup);
    auto upload = engine_.StartUpload(ArrayHeader(soup));
    Require(upload.ok() && (*upload)->Append(0, bytes).ok());
    std::string digest;
    const auto job = engine_.FinishUpload(
        *std::move(upload), [&](const absl::StatusOr<UploadResult>& result) {
          Require(result.ok());
          digest = result->mesh.digest;
        });
    Require(job.ok());
    executor_.RunAll();
    return digest;
  }

  // Frames that gRPC could not read never reach the service.
  template <typename Request>
  bool Read(const RpcFrame& frame, Request& request) const {
    if (!request.ParseFromString(frame.message)) return false;
    SetDigests(request, digests_);
    return true;
  }

  template <typename Service, typename Request, typename Response>
  void BeginCall(const RpcFrame& frame, Service& service,
                 grpc::ServerUnaryReactor* (Service::*method)(
                     grpc::CallbackServerContext*, const Request*, Response*)) {
    Request request;
    if (!Read(frame, request)) return;
    const auto call = [&](auto*... arguments) {
      (service.*method)(arguments...);
    };
    calls_.push_back({.call = std::make_unique<FakeUnary<Request, Response>>(
                          std::move(request), call),
                      .cancel_after = frame.cancel_after});
  }

  template <typename Service, typename Request, typename Response>
  void BeginCall(const RpcFrame& frame, Service& service,
                 grpc::ServerWriteReactor<Response>* (Service::*method)(
                     grpc::CallbackServerContext*, const Request*)) {
    Request request;
    if (!Read(frame, request)) return;
    const auto call = [&](auto*... arguments) {
      return (service.*method)(arguments...);
    };
    const auto check = std::make_shared<AnswerCheck>();
    calls_.push_back(
        {.call = std::make_unique<FakeDownload<Request, Response>>(
             events_, std::move(request),
             [check](const Response& message) { check->Take(message); }, call),
         .check = check,
         .cancel_after = frame.cancel_after});
  }

  void Begin(const RpcScript& script, size_t begin, size_t end);
  void BeginUpload(const RpcScript& script, size_t begin, size_t end);

  // Until nothing happens any more.
  void Pump() {
    size_t count = 0;
    while (!events_.empty() || executor_.size() > 0) {
      Require(++count < kMostEvents);
      if (events_.empty()) {
        executor_.RunOne();
      } else {
        const auto event = std::move(events_.front());
        events_.pop_front();
        event();
      }
      for (const Call& call : calls_) {
        if (call.cancel_after == count && !call.call->is_over()) {
          call.call->Cancel();
        }
      }
    }
    for (const Call& call : calls_) CheckEnd(call);
    calls_.clear();
  }

  static void CheckEnd(const Call& call) {
    Require(call.call->is_over());
    const grpc::Status& status = call.call->status();
    const bool was_cancelled = call.call->was_cancelled();
    if (call.check != nullptr) {
      call.check->End(status, was_cancelled);
    } else if (!status.ok()) {
      CheckRefusal(status, was_cancelled);
    }
  }

  void CheckNothingIsLeft() {
    Require(engine_.scheduler().running() == 0);
    Require(engine_.scheduler().queued() == 0);
    Require(engine_.upload_memory().used() == 0);
    Require(engine_.solver_memory().used() == 0);
    Require(engine_.fields().flights().waiters() == 0);
    Require(log_.active() == 0);
  }

  Events events_;
  FakeClock clock_;
  ManualExecutor executor_;
  AccessControl access_{""};
  Quotas quotas_{clock_};
  Metrics metrics_;
  RequestLog log_{std::make_shared<spdlog::logger>(
                      "", std::make_shared<spdlog::sinks::null_sink_mt>()),
                  /*max_active=*/8, access_, quotas_, metrics_};
  QueryEngine engine_{SmallLimits(), clock_, executor_};
  MeshService meshes_{engine_, log_};
  FieldService fields_{engine_, "1", log_};
  PathService paths_{engine_, "1", log_};
  MatrixService matrices_{engine_, "1", log_};
  CapabilitiesService capabilities_{engine_.limits(), 1 << 22, "1", log_};
  std::vector<std::string> digests_;
  std::vector<Call> calls_;
};

void Subject::BeginUpload(const RpcScript& script, size_t begin, size_t end) {
  std::vector<v1::CreateMeshRequest> requests;
  for (size_t i = begin; i < end; ++i) {
    v1::CreateMeshRequest request;
    if (Read(script[i], request)) requests.push_back(std::move(request));
  }
  using Upload = FakeUpload<v1::CreateMeshRequest, v1::CreateMeshResponse>;
  calls_.push_back({.call = std::make_unique<Upload>(
                        events_, std::move(requests),
                        [this](auto* context, auto* response) {
                          return meshes_.CreateMesh(context, response);
                        }),
                    .cancel_after = script[begin].cancel_after});
}

void Subject::Begin(const RpcScript& script, size_t begin, size_t end) {
  const RpcFrame& frame = script[begin];
  switch (frame.method) {
    case RpcMethod::kGetCapabilities:
      return BeginCall(frame, capabilities_,
                       &CapabilitiesService::GetCapabilities);
    case RpcMethod::kFindMissingMeshes:
      return BeginCall(frame, meshes_, &MeshService::FindMissingMeshes);
    case RpcMethod::kCreateMesh:
      return BeginUpload(script, begin, end);
    case RpcMethod::kGetMesh:
      return BeginCall(frame, meshes_, &MeshService::GetMesh);
    case RpcMethod::kReadMesh:
      return BeginCall(frame, meshes_, &MeshService::ReadMesh);
    case RpcMethod::kListMeshes:
      return BeginCall(frame, meshes_, &MeshService::ListMeshes);
    case RpcMethod::kDeleteMesh:
      return BeginCall(frame, meshes_, &MeshService::DeleteMesh);
    case RpcMethod::kComputeField:
      return BeginCall(frame, fields_, &FieldService::ComputeField);
    case RpcMethod::kComputeLogMap:
      return BeginCall(frame, fields_, &FieldService::ComputeLogMap);
    case RpcMethod::kSampleFarthestPoints:
      return BeginCall(frame, fields_, &FieldService::SampleFarthestPoints);
    case RpcMethod::kComputePaths:
      return BeginCall(frame, paths_, &PathService::ComputePaths);
    case RpcMethod::kComputeIsolines:
      return BeginCall(frame, paths_, &PathService::ComputeIsolines);
    case RpcMethod::kComputeMatrix:
      return BeginCall(frame, matrices_, &MatrixService::ComputeMatrix);
    case RpcMethod::kFindNearest:
      return BeginCall(frame, matrices_, &MatrixService::FindNearest);
  }
}

}  // namespace

void RunScript(const RpcScript& script) { Subject().Run(script); }

}  // namespace geodesic::server::test
