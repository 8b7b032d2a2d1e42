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
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geodesic/v1/answer.pb.h"
#include "server/engine/query_engine.h"
#include "server/operations/metrics.h"
#include "server/rpc/calls/call.h"
#include "server/rpc/calls/intake.h"
#include "server/rpc/calls/peer.h"
#include "server/rpc/calls/request_log.h"
#include "server/rpc/streams/field.h"
#include "server/rpc/streams/isolines.h"
#include "server/rpc/streams/log_map.h"
#include "server/rpc/streams/matrix.h"
#include "server/rpc/streams/mesh_streams.h"
#include "server/rpc/streams/pairs.h"
#include "server/rpc/streams/paths.h"
#include "server/rpc/streams/samples.h"
#include "server/rpc/streams/trace.h"
#include "server/rpc/unary_calls.h"
#include "server/security/access_control.h"
#include "server/security/quotas.h"
#include "tests/engine/fakes.h"
#include "tests/engine/uploads.h"
#include "tests/fuzz/rpc/fake_call.h"
#include "tests/support/meshes/curved_meshes.h"

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

// Letters in fields of these names are replaced by the names they stand for.
void SetNames(google::protobuf::Message& message,
              std::initializer_list<const char*> fields,
              const std::vector<std::string>& names) {
  const Reflection& reflection = *message.GetReflection();
  const auto replaced = [&](const std::string& text) {
    const auto number = static_cast<size_t>(text.empty() ? 0 : text[0] - 'A');
    return text.size() == 1 && number < names.size() ? names[number] : text;
  };
  for (const char* name : fields) {
    const FieldDescriptor* field =
        message.GetDescriptor()->FindFieldByName(name);
    if (field == nullptr) continue;
    if (!field->is_repeated()) {
      reflection.SetString(&message, field,
                           replaced(reflection.GetString(message, field)));
      continue;
    }
    for (int i = 0; i < reflection.FieldSize(message, field); ++i) {
      reflection.SetRepeatedString(
          &message, field, i,
          replaced(reflection.GetRepeatedString(message, field, i)));
    }
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

// How many bytes a number takes.
size_t SizeOf(v1::ValueType type) {
  if (type == v1::VALUE_TYPE_UINT8) return 1;
  return type == v1::VALUE_TYPE_FLOAT64 || type == v1::VALUE_TYPE_UINT64 ? 8
                                                                         : 4;
}

// The messages of one streamed answer, in order. Aborts the program unless they
// begin with a header and, but for a mesh, end with a trailer, arrays have no
// gaps, and no distance is negative or not a number.
class AnswerCheck {
 public:
  void Take(const google::protobuf::Message& message) {
    if (const auto* answer = dynamic_cast<const v1::Answer*>(&message)) {
      TakeAnswer(*answer);
    } else {
      const auto& mesh = static_cast<const v1::ReadMeshResponse&>(message);
      Require(mesh.has_header() == !has_begun_);
      is_complete_ = true;
    }
    has_begun_ = true;
  }

  // After the last message.
  void End(const grpc::Status& status, bool was_cancelled) const {
    if (status.ok()) {
      Require(is_complete_);
    } else {
      CheckRefusal(status, was_cancelled);
    }
  }

  // "" if it has none.
  const std::string& answer_id() const { return answer_id_; }

 private:
  void TakeAnswer(const v1::Answer& answer) {
    Require(!is_complete_ && answer.has_header() == !has_begun_);
    if (answer.has_header()) header_ = answer.header();
    is_complete_ = answer.has_trailer();
    answer_id_ += answer.answer_id();
    for (const v1::Block& block : answer.blocks()) {
      Require(block.array() < static_cast<uint32_t>(header_.arrays_size()));
      const v1::ArrayInfo& array = header_.arrays(block.array());
      // One that is resumed begins anywhere.
      uint64_t& next =
          next_.try_emplace(block.array(), block.first()).first->second;
      Require(block.first() == next);
      next += block.values().size() / SizeOf(array.type());
      if (array.type() == v1::VALUE_TYPE_FLOAT64 &&
          (array.name().ends_with("distance") || array.name() == "length")) {
        CheckDistances(block.values());
      }
    }
  }

  bool has_begun_ = false;
  bool is_complete_ = false;
  v1::AnswerHeader header_;
  std::string answer_id_;
  std::map<uint32_t, uint64_t> next_;  // numbers, by array
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

  // The frame's message with names in place of letters; as it is if it is
  // malformed.
  std::string Message(const RpcFrame& frame) const {
    const auto request = NewRequest(frame.method);
    if (!request->ParseFromString(frame.message)) return frame.message;
    SetNames(*request, {"digest", "mesh_digest", "mesh_digests"}, digests_);
    const FieldDescriptor* resumption =
        request->GetDescriptor()->FindFieldByName("resumption");
    const Reflection& reflection = *request->GetReflection();
    if (resumption != nullptr && reflection.HasField(*request, resumption)) {
      SetNames(*reflection.MutableMessage(request.get(), resumption),
               {"answer_id"}, answer_ids_);
    }
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

  void CheckEnd(const Call& call) {
    Require(call.call->is_over());
    const grpc::Status& status = call.call->status();
    const bool was_cancelled = call.call->was_cancelled();
    if (call.check != nullptr) {
      call.check->End(status, was_cancelled);
      answer_ids_.insert(answer_ids_.begin(), call.check->answer_id());
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
  std::vector<std::string> answer_ids_;  // that of the last answer first
  std::vector<Call> calls_;
};

}  // namespace

void RunScript(const RpcScript& script) { Subject().Run(script); }

}  // namespace geodesic::server::test
