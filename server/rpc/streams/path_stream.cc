#include "server/rpc/streams/path_stream.h"

#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "geodesic/field_path.h"
#include "server/rpc/messages/polyline.h"
#include "server/rpc/messages/surface_translation.h"

namespace geodesic::server {

absl::Status PathStream::Translate(FieldRequest& question) {
  question.extras.paths = true;
  absl::Status status =
      AddSources(request().sources(), engine().limits(), question.query);
  if (!status.ok()) return status;
  absl::StatusOr<std::vector<SurfacePoint>> targets =
      TargetsFromProto(request().targets(), engine().limits());
  if (!targets.ok()) return targets.status();
  if (targets->empty()) {
    return InvalidField("targets", "targets is empty: name at least one");
  }
  question.query.targets = *std::move(targets);
  question.reach.targets = question.query.targets.size();
  return absl::OkStatus();
}

absl::StatusOr<GeodesicPath> PathStream::TraceNext() {
  const auto* vertex =
      std::get_if<VertexPoint>(&call().query->targets[next_target_]);
  const bool is_own =
      vertex == nullptr ||
      answer().field->target_distances.size() == call().query->targets.size();
  const uint32_t own = is_own ? next_own_target_++ : 0;
  ++next_target_;
  const double distance = is_own ? answer().field->target_distances[own]
                                 : answer().field->distances[vertex->vertex];
  // The field may reach further than was asked.
  if (distance > call().reach.radius) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return GeodesicPath{.distance = kInfinity, .length = kInfinity};
  }
  const PathTracer& paths = *answer().derived->paths;
  return is_own ? paths.ToTarget(own) : paths.ToVertex(vertex->vertex);
}

absl::StatusOr<bool> PathStream::FillPart(v1::ComputePathsResponse& message) {
  if (next_target_ > 0 && next_point_ < path_.points.size()) {
    // More of the same path.
    next_point_ = SetPiece(path_.points, path_.positions, next_point_,
                           *message.mutable_path()->mutable_piece());
    return true;
  }
  if (next_target_ == call().query->targets.size()) return false;
  const uint32_t target = next_target_;
  absl::StatusOr<GeodesicPath> path = TraceNext();
  if (!path.ok()) return path.status();
  path_ = *std::move(path);
  v1::GeodesicPath& proto = *message.mutable_path();
  proto.set_target(target);
  proto.set_length(path_.length);
  proto.set_distance(path_.distance);
  proto.clear_source();
  if (!path_.points.empty()) {
    proto.set_source(call().source_numbers[path_.source]);
  }
  next_point_ =
      SetPiece(path_.points, path_.positions, 0, *proto.mutable_piece());
  entry().add_bytes(path_.points.size() * sizeof(Point));
  return true;
}

}  // namespace geodesic::server
