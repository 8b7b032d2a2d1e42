#include "server/rpc/path_stream.h"

#include <limits>
#include <utility>
#include <variant>

#include "server/engine/status_details.h"
#include "server/rpc/call_deadline.h"
#include "server/rpc/field_translation.h"
#include "server/rpc/polyline.h"
#include "server/rpc/surface_translation.h"

namespace geodesic::server {

grpc::ServerWriteReactor<v1::ComputePathsResponse>* PathStream::Start(
    QueryEngine& engine, RequestLog& log, const std::string& version,
    grpc::CallbackServerContext& context,
    const v1::ComputePathsRequest& request) {
  return Launch(std::shared_ptr<PathStream>(
      new PathStream(engine, log, version, context, request)));
}

PathStream::PathStream(QueryEngine& engine, RequestLog& log,
                       const std::string& version,
                       grpc::CallbackServerContext& context,
                       const v1::ComputePathsRequest& request)
    : QuestionStream(engine, log, "ComputePaths", request.mesh_digest(),
                     version, context),
      context_(context),
      request_(request) {}

absl::Status PathStream::Ask() {
  absl::StatusOr<Requester> requester = MakeRequester(request_.priority());
  if (!requester.ok()) return requester.status();
  FieldRequest query{.mesh_digest = request_.mesh_digest(),
                     .extras = {.paths = true},
                     .deadline = CallDeadline(context_),
                     .requester = *std::move(requester)};
  absl::StatusOr<Algorithm> algorithm = FromProto(request_.algorithm());
  if (!algorithm.ok()) return algorithm.status();
  query.query.algorithm = *algorithm;
  absl::Status status = AddSources(request_.sources(), engine().limits(),
                                   query.query, query.numbers);
  if (!status.ok()) return status;
  absl::StatusOr<std::vector<SurfacePoint>> targets =
      TargetsFromProto(request_.targets(), engine().limits());
  if (!targets.ok()) return targets.status();
  if (targets->empty()) {
    return InvalidField("targets", "targets is empty: name at least one");
  }
  query.query.targets = *std::move(targets);
  query.reach.targets = query.query.targets.size();
  if (request_.has_max_distance()) {
    query.reach.radius = request_.max_distance();
  }
  absl::StatusOr<FieldCall> call = engine().ComputeField(
      query, std::static_pointer_cast<PathStream>(shared_from_this()));
  if (!call.ok()) return call.status();
  call_ = *std::move(call);
  SetSubject(call_.mesh, call_.query.algorithm);
  return absl::OkStatus();
}

void PathStream::Cancel() { engine().Cancel(call_); }

void PathStream::OnProgress(const Progress& progress) { SetProgress(progress); }

void PathStream::OnField(const absl::StatusOr<FieldAnswer>& answer) {
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

absl::StatusOr<GeodesicPath> PathStream::TraceNext() {
  const auto* vertex =
      std::get_if<VertexPoint>(&call_.query.targets[next_target_]);
  const bool is_own = vertex == nullptr || answer_.query->targets.size() ==
                                               call_.query.targets.size();
  const uint32_t own = is_own ? next_own_target_++ : 0;
  ++next_target_;
  const double distance = is_own ? answer_.field->target_distances[own]
                                 : answer_.field->distances[vertex->vertex];
  // The field may reach further than was asked.
  if (distance > call_.reach.radius) {
    return GeodesicPath{.length = std::numeric_limits<double>::infinity()};
  }
  const PathTracer& paths = *answer_.derived->paths;
  return is_own ? paths.ToTarget(own) : paths.ToVertex(vertex->vertex);
}

absl::StatusOr<bool> PathStream::FillPart(v1::ComputePathsResponse& message) {
  if (next_target_ > 0 && next_point_ < path_.points.size()) {
    // More of the same path.
    next_point_ = SetPiece(path_.points, path_.positions, next_point_,
                           *message.mutable_path()->mutable_piece());
    return true;
  }
  if (next_target_ == call_.query.targets.size()) return false;
  const uint32_t target = next_target_;
  absl::StatusOr<GeodesicPath> path = TraceNext();
  if (!path.ok()) return path.status();
  path_ = *std::move(path);
  v1::GeodesicPath& proto = *message.mutable_path();
  proto.set_target(target);
  proto.set_length(path_.length);
  proto.set_distance(path_.length);
  proto.clear_source();
  if (!path_.points.empty()) {
    const std::vector<Source>& points = call_.query.sources;
    proto.set_source(call_.source_numbers[path_.source]);
    proto.set_distance(
        path_.length +
        (path_.source < points.size()
             ? points[path_.source].offset
             : call_.query.curves[path_.source - points.size()].offset));
  }
  next_point_ =
      SetPiece(path_.points, path_.positions, 0, *proto.mutable_piece());
  entry().add_bytes(path_.points.size() * sizeof(Point));
  return true;
}

uint64_t PathStream::item_count() const { return next_target_; }

}  // namespace geodesic::server
