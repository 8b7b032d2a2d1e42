#include "server/rpc/nearest_stream.h"

#include <memory>
#include <utility>
#include <vector>

#include "server/rpc/call_deadline.h"
#include "server/rpc/field_translation.h"
#include "server/rpc/surface_translation.h"

namespace geodesic::server {

grpc::ServerWriteReactor<v1::FindNearestResponse>* NearestStream::Start(
    QueryEngine& engine, RequestLog& log, const std::string& version,
    grpc::CallbackServerContext& context,
    const v1::FindNearestRequest& request) {
  return Launch(std::shared_ptr<NearestStream>(
      new NearestStream(engine, log, version, context, request)));
}

NearestStream::NearestStream(QueryEngine& engine, RequestLog& log,
                             const std::string& version,
                             grpc::CallbackServerContext& context,
                             const v1::FindNearestRequest& request)
    : RowStream(engine, log, "FindNearest", request.mesh_digest(), version,
                context),
      context_(context),
      request_(request) {}

absl::StatusOr<NearestStream::Question> NearestStream::Translate(
    const Limits& limits) const {
  Question question{.request = {.mesh_digest = request_.mesh_digest(),
                                .deadline = CallDeadline(context_)},
                    .priority = request_.priority()};
  const absl::StatusOr<v1::ValueType> value_type =
      ResolveValueType(request_.value_type());
  if (!value_type.ok()) return value_type.status();
  question.value_type = *value_type;
  const absl::StatusOr<Algorithm> algorithm = FromProto(request_.algorithm());
  if (!algorithm.ok()) return algorithm.status();
  Query& query = question.request.query;
  query.algorithm = *algorithm;
  question.request.nearest = request_.count();
  const absl::Status status =
      AddRows(request_.sources(), limits, query, question.request.numbers);
  if (!status.ok()) return status;
  absl::StatusOr<std::vector<SurfacePoint>> targets =
      TargetsFromProto(request_.targets(), limits);
  if (!targets.ok()) return targets.status();
  query.targets = *std::move(targets);
  if (request_.has_max_distance()) {
    question.request.radius = request_.max_distance();
  }
  return question;
}

NearestStream::Chunk NearestStream::MakeChunk(v1::FindNearestResponse& message,
                                              uint64_t row,
                                              uint64_t value_count,
                                              uint64_t offset) const {
  auto& chunk = *message.mutable_chunk();
  chunk.set_row(row);
  chunk.set_value_count(value_count);
  chunk.set_offset(offset);
  return {chunk.mutable_targets(), chunk.mutable_distances()};
}

}  // namespace geodesic::server
