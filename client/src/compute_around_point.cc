// Client::SampleFarthestPoints and ComputeLogMap: what follows from one
// computation, off a server stream.

#include <utility>

#include "absl/strings/str_cat.h"
#include "answer_stream.h"
#include "connection.h"
#include "wire_values.h"

namespace geodesic::client {

absl::StatusOr<SampleAnswer> Client::SampleFarthestPoints(
    const SampleQuery& query, const CallOptions& options,
    const SolveProgressCallback& progress) {
  auto request = MakeRequest<v1::SampleFarthestPointsRequest>(query);
  if (!request.ok()) return request.status();
  request->set_count(query.count);

  SampleAnswer answer;
  const auto take = [&](const v1::SampleFarthestPointsResponse& response) {
    for (const v1::FarthestSample& sample : response.samples().samples()) {
      answer.samples.push_back({sample.vertex(), sample.distance()});
    }
    return answer.samples.size() <= query.count
               ? absl::OkStatus()
               : absl::DataLossError(
                     "the server sent more samples than were asked for");
  };
  Call call(options);
  absl::StatusOr<AnswerInfo> info = ReadAnswer(
      &call,
      connection_->fields->SampleFarthestPoints(call.context(), *request),
      ReportTo(progress), take, [&answer] { return answer.samples.size(); });
  if (!info.ok()) return info.status();
  answer.info = *std::move(info);
  return answer;
}

absl::StatusOr<LogMap> Client::ComputeLogMap(
    const LogMapQuery& query, const CallOptions& options,
    const SolveProgressCallback& progress) {
  auto request = MakeRequest<v1::ComputeLogMapRequest>(query);
  if (!request.ok()) return request.status();
  *request->mutable_source() = ToProto(query.source);

  LogMap map;
  bool has_frame = false;
  const auto take = [&](const v1::ComputeLogMapResponse& response) {
    if (response.has_frame()) {
      has_frame = true;
      map.zero_direction = FromProto(response.frame().zero_direction());
    } else if (response.has_chunk()) {
      const v1::LogMapChunk& chunk = response.chunk();
      if (chunk.offset() != map.coordinates.size() ||
          !AppendValues(chunk.coordinates(), query.value_type,
                        &map.coordinates)) {
        return absl::DataLossError(
            "the server sent other parts of a log map than were due");
      }
    }
    return absl::OkStatus();
  };
  Call call(options);
  absl::StatusOr<AnswerInfo> info = ReadAnswer(
      &call, connection_->fields->ComputeLogMap(call.context(), *request),
      ReportTo(progress), take, [&map] { return map.coordinates.size(); });
  if (!info.ok()) return info.status();
  if (!has_frame || map.coordinates.size() != info->vertex_count) {
    return absl::DataLossError(
        absl::StrCat("the server sent ", map.coordinates.size(), " of ",
                     info->vertex_count, " vertices of a log map"));
  }
  map.info = *std::move(info);
  return map;
}

}  // namespace geodesic::client
