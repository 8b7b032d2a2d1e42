// Client::SampleFarthestPoints and ComputeLogMap: what follows from one
// computation, off a server stream.

#include <cstring>
#include <utility>

#include "absl/strings/str_cat.h"
#include "answer_stream.h"
#include "connection.h"
#include "wire_values.h"

namespace geodesic::client {

absl::StatusOr<SampleAnswer> Client::SampleFarthestPoints(
    const SampleQuery& query, const CallOptions& options,
    const SolveProgressCallback& progress) {
  v1::SampleFarthestPointsRequest request;
  if (absl::Status status = SetCommon(query, &request); !status.ok()) {
    return status;
  }
  AddAll(query.sources, request.mutable_sources());
  request.set_count(query.count);

  SampleAnswer answer;
  const auto part = [&](const v1::SampleFarthestPointsResponse& response) {
    for (const v1::FarthestSample& sample : response.samples().samples()) {
      answer.samples.push_back({sample.vertex(), sample.distance()});
    }
    return answer.samples.size() <= query.count
               ? absl::OkStatus()
               : absl::DataLossError(
                     "the server sent more samples than were asked for");
  };
  Call call(options);
  absl::StatusOr<AnswerInfo> info =
      ReadAnswer<v1::SampleFarthestPointsResponse>(
          &call,
          connection_->fields->SampleFarthestPoints(call.context(), request),
          SolveHandlers(progress, part),
          [&answer] { return answer.samples.size(); });
  if (!info.ok()) return info.status();
  answer.info = *std::move(info);
  return answer;
}

absl::StatusOr<LogMap> Client::ComputeLogMap(
    const LogMapQuery& query, const CallOptions& options,
    const SolveProgressCallback& progress) {
  v1::ComputeLogMapRequest request;
  if (absl::Status status = SetCommon(query, &request); !status.ok()) {
    return status;
  }
  *request.mutable_source() = ToProto(query.source);
  request.set_value_type(ToProto(query.value_type));
  if (query.radius.has_value()) {
    request.set_radius(*query.radius);
  }

  LogMap map;
  bool has_frame = false;
  std::vector<double> values;  // u and v of each vertex
  const auto part = [&](const v1::ComputeLogMapResponse& response) {
    if (response.has_frame()) {
      has_frame = true;
      map.zero_direction = FromProto(response.frame().zero_direction());
    } else if (response.has_chunk()) {
      const v1::LogMapChunk& chunk = response.chunk();
      if (2 * chunk.offset() != values.size() ||
          !AppendValues(chunk.coordinates(), query.value_type, &values) ||
          values.size() % 2 != 0) {
        return absl::DataLossError(
            "the server sent other parts of a log map than were due");
      }
    }
    return absl::OkStatus();
  };
  Call call(options);
  absl::StatusOr<AnswerInfo> info = ReadAnswer<v1::ComputeLogMapResponse>(
      &call, connection_->fields->ComputeLogMap(call.context(), request),
      SolveHandlers(progress, part), [&values] { return values.size() / 2; });
  if (!info.ok()) return info.status();
  if (!has_frame || values.size() / 2 != info->vertex_count) {
    return absl::DataLossError(
        absl::StrCat("the server sent ", values.size() / 2, " of ",
                     info->vertex_count, " vertices of a log map"));
  }
  map.coordinates.resize(values.size() / 2);
  for (size_t v = 0; v < map.coordinates.size(); ++v) {
    map.coordinates[v] = {values[2 * v], values[2 * v + 1]};
  }
  map.info = *std::move(info);
  return map;
}

}  // namespace geodesic::client
