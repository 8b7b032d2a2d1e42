// Client::ComputePaths and ComputeIsolines: polylines off a server stream.

#include <utility>

#include "absl/strings/str_cat.h"
#include "answer_stream.h"
#include "assemblers.h"
#include "connection.h"

namespace geodesic::client {
namespace {

absl::Status OutOfOrder(std::string_view what, uint64_t number,
                        uint64_t expected) {
  return absl::DataLossError(absl::StrCat("the server sent ", std::string(what),
                                          " ", number, " where ", expected,
                                          " was due"));
}

}  // namespace

absl::StatusOr<PathAnswer> Client::ComputePaths(
    const PathQuery& query, const CallOptions& options,
    const SolveProgressCallback& progress) {
  const auto request = MakeRequest<v1::ComputePathsRequest>(query);
  if (!request.ok()) return request.status();

  PathAnswer answer;
  PolylineAssembler assembler;
  const auto take = [&](const v1::ComputePathsResponse& response) {
    if (!response.has_path()) return absl::OkStatus();
    const v1::GeodesicPath& message = response.path();
    if (assembler.complete()) {
      GeodesicPath& path = answer.paths.emplace_back();
      if (message.has_source()) path.source = message.source();
      path.distance = message.distance();
      path.length = message.length();
    }
    const uint64_t due = answer.paths.size() - 1;
    if (message.target() != due) {
      return OutOfOrder("the path to target", message.target(), due);
    }
    return assembler.Consume(message.piece(), &answer.paths.back().line);
  };
  Call call(options);
  absl::StatusOr<AnswerInfo> info = ReadAnswer(
      &call, connection_->paths->ComputePaths(call.context(), *request),
      ReportTo(progress), take, [&answer] { return answer.paths.size(); });
  if (!info.ok()) return info.status();
  if (!assembler.complete() || answer.paths.size() != query.targets.size()) {
    return absl::DataLossError(
        absl::StrCat("the server ended its answer after ", answer.paths.size(),
                     " of ", query.targets.size(), " paths"));
  }
  answer.info = *std::move(info);
  return answer;
}

absl::StatusOr<IsolineAnswer> Client::ComputeIsolines(
    const IsolineQuery& query, const CallOptions& options,
    const SolveProgressCallback& progress) {
  auto request = MakeRequest<v1::ComputeIsolinesRequest>(query);
  if (!request.ok()) return request.status();
  request->mutable_levels()->Add(query.levels.begin(), query.levels.end());

  IsolineAnswer answer;
  PolylineAssembler assembler;
  const auto take = [&](const v1::ComputeIsolinesResponse& response) {
    if (!response.has_isoline()) return absl::OkStatus();
    const v1::Isoline& message = response.isoline();
    if (assembler.complete()) {
      answer.isolines.push_back(
          {.level = message.level(), .is_closed = message.is_closed()});
    }
    const uint64_t due = answer.isolines.size() - 1;
    if (message.number() != due) {
      return OutOfOrder("isoline", message.number(), due);
    }
    return assembler.Consume(message.piece(), &answer.isolines.back().line);
  };
  Call call(options);
  absl::StatusOr<AnswerInfo> info = ReadAnswer(
      &call, connection_->paths->ComputeIsolines(call.context(), *request),
      ReportTo(progress), take, [&answer] { return answer.isolines.size(); });
  if (!info.ok()) return info.status();
  if (!assembler.complete()) {
    return absl::DataLossError("the server's answer ended within an isoline");
  }
  answer.info = *std::move(info);
  return answer;
}

}  // namespace geodesic::client
