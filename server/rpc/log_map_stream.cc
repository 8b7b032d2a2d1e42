#include "server/rpc/log_map_stream.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "server/rpc/call_deadline.h"
#include "server/rpc/field_translation.h"
#include "server/rpc/surface_translation.h"
#include "server/rpc/value_bytes.h"

namespace geodesic::server {
namespace {

constexpr uint64_t kVerticesPerChunk = 32768;

}  // namespace

grpc::ServerWriteReactor<v1::ComputeLogMapResponse>* LogMapStream::Start(
    QueryEngine& engine, RequestLog& log, const std::string& version,
    grpc::CallbackServerContext& context,
    const v1::ComputeLogMapRequest& request) {
  return Launch(std::shared_ptr<LogMapStream>(
      new LogMapStream(engine, log, version, context, request)));
}

LogMapStream::LogMapStream(QueryEngine& engine, RequestLog& log,
                           const std::string& version,
                           grpc::CallbackServerContext& context,
                           const v1::ComputeLogMapRequest& request)
    : QuestionStream(engine, log, "ComputeLogMap", request.mesh_digest(),
                     version, context),
      context_(context),
      request_(request) {}

absl::Status LogMapStream::Ask() {
  const absl::StatusOr<v1::ValueType> value_type =
      ResolveValueType(request_.value_type());
  if (!value_type.ok()) return value_type.status();
  value_type_ = *value_type;
  absl::StatusOr<Requester> requester = MakeRequester(request_.priority());
  if (!requester.ok()) return requester.status();
  FieldRequest query{.mesh_digest = request_.mesh_digest(),
                     .numbers = {.is_single = true},
                     .extras = {.log_map = true},
                     .deadline = CallDeadline(context_),
                     .requester = *std::move(requester)};
  absl::StatusOr<Algorithm> algorithm = FromProto(request_.algorithm());
  if (!algorithm.ok()) return algorithm.status();
  query.query.algorithm = *algorithm;
  absl::StatusOr<SurfacePoint> source = FromProto(request_.source(), "source");
  if (!source.ok()) return source.status();
  query.query.sources = {{*source, 0}};
  if (request_.has_max_distance()) {
    query.reach.radius = request_.max_distance();
  }
  absl::StatusOr<FieldCall> call = engine().ComputeField(
      query, std::static_pointer_cast<LogMapStream>(shared_from_this()));
  if (!call.ok()) return call.status();
  call_ = *std::move(call);
  SetSubject(call_.mesh, call_.query.algorithm);
  return absl::OkStatus();
}

void LogMapStream::Cancel() { engine().Cancel(call_); }

void LogMapStream::OnProgress(const Progress& progress) {
  SetProgress(progress);
}

void LogMapStream::OnField(const absl::StatusOr<FieldAnswer>& answer) {
  if (!answer.ok()) {
    SetFinished(answer.status(), {}, [] {});
    return;
  }
  const SolveStatistics& statistics = answer->field->statistics;
  const bool computed = answer->origin != FieldOrigin::kCached;
  SetFinished(absl::OkStatus(),
              computed ? AnswerCost{statistics.solve_seconds,
                                    statistics.windows_propagated}
                       : AnswerCost{},
              [&] { answer_ = *answer; });
}

absl::StatusOr<bool> LogMapStream::FillPart(
    v1::ComputeLogMapResponse& message) {
  const LogMap& map = answer_.derived->log_map;
  if (!std::exchange(has_frame_, true)) {
    v1::Point& direction = *message.mutable_frame()->mutable_zero_direction();
    direction.set_x(map.zero_direction[0]);
    direction.set_y(map.zero_direction[1]);
    direction.set_z(map.zero_direction[2]);
    return true;
  }
  const uint64_t end = std::min<uint64_t>(next_vertex_ + kVerticesPerChunk,
                                          map.coordinates.size());
  if (next_vertex_ == end) return false;
  v1::LogMapChunk& chunk = *message.mutable_chunk();
  chunk.set_offset(next_vertex_);
  values_.clear();
  for (; next_vertex_ < end; ++next_vertex_) {
    // The field may reach further than was asked.
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const auto& uv =
        answer_.field->distances[next_vertex_] <= call_.reach.radius
            ? map.coordinates[next_vertex_]
            : std::array<double, 2>{kNone, kNone};
    values_.insert(values_.end(), uv.begin(), uv.end());
  }
  SetValues(values_, value_type_, *chunk.mutable_coordinates());
  entry().add_bytes(chunk.coordinates().size());
  return true;
}

uint64_t LogMapStream::item_count() const { return next_vertex_; }

}  // namespace geodesic::server
