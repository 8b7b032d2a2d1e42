#include "tests/fuzz/rpc/rpc_subject.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <google/rpc/error_details.pb.h>
#include <google/rpc/status.pb.h>
#include <grpcpp/support/status.h>
#include <spdlog/sinks/null_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geodesic/v1/field_service.pb.h"
#include "geodesic/v1/query.pb.h"
#include "server/engine/query_engine.h"
#include "server/operations/metrics.h"
#include "server/rpc/calls/call.h"
#include "server/rpc/calls/intake.h"
#include "server/rpc/calls/peer.h"
#include "server/rpc/calls/request_log.h"
#include "server/rpc/streams/field_stream.h"
#include "server/rpc/streams/mesh_streams.h"
#include "server/rpc/streams/pair_stream.h"
#include "server/rpc/streams/question_streams.h"
#include "server/rpc/streams/row_stream.h"
#include "server/rpc/unary_calls.h"
#include "server/security/access_control.h"
#include "server/security/quotas.h"
#include "tests/engine/fakes.h"
#include "tests/engine/uploads.h"
#include "tests/fuzz/rpc/fake_call.h"
#include "tests/support/curved_meshes.h"

namespace geodesic::server::test {
namespace {

using geodesic::test::Terrain;
using geodesic::test::Torus;
using google::protobuf::FieldDescriptor;
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
  limits.max_pairs = 40;
  limits.max_matrix_rows = 40;
  limits.max_matrix_values = 1'000;
  limits.max_queued_jobs = 4;
  limits.mesh_store_bytes = 1 << 20;
  limits.field_cache_bytes = 1 << 16;
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
void SetDigests(google::protobuf::Message& message,
                const std::vector<std::string>& digests) {
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

// Aborts the program unless the status has a code that says nothing of faults
// of the server, a message, and a google.rpc.ErrorInfo.
// REQUIRES: it is not OK.
void CheckRefusal(const grpc::Status& status, bool was_cancelled) {
  switch (status.error_code()) {
    case grpc::StatusCode::INVALID_ARGUMENT:
    case grpc::StatusCode::NOT_FOUND:
    case grpc::StatusCode::RESOURCE_EXHAUSTED:
      break;
    case grpc::StatusCode::CANCELLED:
      Require(was_cancelled);
      break;
    default:
      std::abort();
  }
  Require(!status.error_message().empty());
  google::rpc::Status details;
  Require(details.ParseFromString(status.error_details()));
  Require(std::any_of(details.details().begin(), details.details().end(),
                      [](const auto& any) {
                        return any.template Is<google::rpc::ErrorInfo>();
                      }));
}

void CheckDistances(const std::string& bytes) {
  std::vector<double> values(bytes.size() / sizeof(double));
  bytes.copy(reinterpret_cast<char*>(values.data()),
             values.size() * sizeof(double));
  for (const double value : values) Require(value >= 0);
}

// The messages of one streamed answer, in order. Aborts the program unless they
// begin with a header and, if the method has one, end with a trailer, and no
// distance is negative or not a number.
class AnswerCheck {
 public:
  void Take(const google::protobuf::Message& message) {
    const auto* type = message.GetDescriptor();
    const auto* part = message.GetReflection()->GetOneofFieldDescriptor(
        message, type->FindOneofByName("part"));
    Require(part != nullptr);
    const bool is_header = part->name() == "header";
    Require(is_header == !has_begun_ && !has_trailer_);
    has_begun_ = true;
    has_trailer_ = part->name() == "trailer";
    promises_trailer_ = type->name() != "ReadMeshResponse";
    if (type->name() == "ComputeFieldResponse") {
      CheckField(static_cast<const v1::ComputeFieldResponse&>(message));
    }
  }

  // After the last message.
  void End(const grpc::Status& status, bool was_cancelled) const {
    if (status.ok()) {
      Require(has_begun_ && has_trailer_ == promises_trailer_);
    } else {
      CheckRefusal(status, was_cancelled);
    }
  }

 private:
  void CheckField(const v1::ComputeFieldResponse& message) {
    if (message.has_header()) value_type_ = message.header().value_type();
    if (value_type_ != v1::VALUE_TYPE_FLOAT64) return;
    CheckDistances(message.chunk().distances());
    CheckDistances(message.targets().distances());
    CheckDistances(message.settled().distances());
  }

  bool has_begun_ = false;
  bool has_trailer_ = false;
  bool promises_trailer_ = true;
  v1::ValueType value_type_ = v1::VALUE_TYPE_UNSPECIFIED;
};

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
    auto upload = engine_.meshes().StartUpload(ArrayHeader(soup));
    Require(upload.ok() && (*upload)->Append(0, bytes).ok());
    std::string digest;
    const auto job = engine_.meshes().FinishUpload(
        *std::move(upload), [&](const absl::StatusOr<UploadResult>& result) {
          Require(result.ok());
          digest = result->mesh.digest;
        });
    Require(job.ok());
    executor_.RunAll();
    return digest;
  }

  // The frame's message with digests in place of letters; as it is if it is
  // malformed.
  std::string Message(const RpcFrame& frame) const {
    const auto request = NewRequest(frame.method);
    if (!request->ParseFromString(frame.message)) return frame.message;
    SetDigests(*request, digests_);
    return request->SerializeAsString();
  }

  template <typename Type>
  void BeginUnary(const RpcFrame& frame) {
    BeginCall<Type>({Message(frame)}, frame.cancel_after, nullptr);
  }

  template <typename Type>
  void BeginStream(const RpcFrame& frame) {
    BeginCall<Type>({Message(frame)}, frame.cancel_after,
                    std::make_shared<AnswerCheck>());
  }

  template <typename Type>
  void BeginCall(std::vector<std::string> messages, size_t cancel_after,
                 const std::shared_ptr<AnswerCheck>& check) {
    const auto take = [check](const typename Type::Response& message) {
      if (check != nullptr) check->Take(message);
    };
    calls_.push_back({.call = std::make_unique<FakeCallOf<Type>>(
                          events_, service_, std::move(messages), take),
                      .check = check,
                      .cancel_after = cancel_after});
  }

  void Begin(const RpcScript& script, size_t begin, size_t end) {
    // In the order of RpcMethod.
    static constexpr void (Subject::*kBegin[kRpcMethods])(const RpcFrame&) = {
        &Subject::BeginUnary<CapabilitiesCall>,
        &Subject::BeginUnary<FindMissingCall>,
        nullptr,  // an upload has many frames
        &Subject::BeginUnary<GetMeshCall>,
        &Subject::BeginStream<MeshStream>,
        &Subject::BeginUnary<ListMeshesCall>,
        &Subject::BeginUnary<DeleteMeshCall>,
        &Subject::BeginStream<FieldStream>,
        &Subject::BeginStream<LogMapStream>,
        &Subject::BeginStream<SampleStream>,
        &Subject::BeginStream<PathStream>,
        &Subject::BeginStream<IsolineStream>,
        &Subject::BeginStream<MatrixStream>,
        &Subject::BeginStream<NearestStream>,
        &Subject::BeginStream<PairStream>};
    const RpcFrame& frame = script[begin];
    if (frame.method != RpcMethod::kCreateMesh) {
      (this->*kBegin[static_cast<size_t>(frame.method)])(frame);
      return;
    }
    std::vector<std::string> messages;
    for (size_t i = begin; i < end; ++i) {
      messages.push_back(Message(script[i]));
    }
    BeginCall<UploadStream>(std::move(messages), frame.cancel_after, nullptr);
  }

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
    // Searches are kept for a while.
    clock_.Advance(SearchPool::kPatience);
    engine_.searches().pool().DropOld();
    Require(engine_.solver_memory().used() == 0);
    Require(engine_.fields().jobs().waiters() == 0);
    Require(log_.active() == 0);
    Require(intake_.memory().used() == 0);
  }

  Events events_;
  FakeClock clock_;
  ManualExecutor executor_;
  AccessControl access_{""};
  Quotas quotas_{clock_};
  Metrics metrics_;
  RequestLog log_{std::make_shared<spdlog::logger>(
                      "", std::make_shared<spdlog::sinks::null_sink_mt>()),
                  /*max_active=*/8,
                  access_,
                  access_,
                  quotas_,
                  metrics_};
  QueryEngine engine_{SmallLimits(), clock_, executor_};
  // Nothing is late here.
  Intake intake_{{.patience = std::chrono::hours(24), .memory_bytes = 1 << 22}};
  const Peers peers_;
  const ServiceContext service_{
      engine_,
      log_,
      intake_,
      peers_,
      MakeCapabilities(engine_.limits(), 1 << 22, "1"),
      std::chrono::hours(24)};
  std::vector<std::string> digests_;
  std::vector<Call> calls_;
};

}  // namespace

void RunScript(const RpcScript& script) { Subject().Run(script); }

}  // namespace geodesic::server::test
