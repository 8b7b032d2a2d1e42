// Client's questions beside fields, each answered by a server stream.

#include <memory>
#include <utility>

#include "absl/strings/str_cat.h"
#include "assemblers.h"
#include "connection.h"
#include "read_answer.h"
#include "translate.h"

namespace geodesic::client {
namespace {

absl::Status OutOfOrder(std::string_view what, uint64_t number,
                        uint64_t expected) {
  return absl::DataLossError(absl::StrCat("the server sent ", std::string(what),
                                          " ", number, " where ", expected,
                                          " was due"));
}

absl::Status EndedWithin(std::string_view what) {
  return absl::DataLossError(
      absl::StrCat("the server's answer ended within ", std::string(what)));
}

// Hands the progress of one computation to `callback`, which may be empty.
auto ReportTo(const SolveProgressCallback& callback) {
  return [&callback](const v1::SolveProgress& message, const AnswerInfo& info) {
    if (callback != nullptr) callback(FromProto(message, info.vertex_count));
  };
}

// Hands the progress of `rows` computations to `callback`, which may be empty.
auto ReportTo(const CountProgressCallback& callback, uint64_t rows) {
  return
      [&callback, rows](const v1::MatrixProgress& message, const AnswerInfo&) {
        if (callback != nullptr) callback(message.rows_finished(), rows);
      };
}

absl::Status CheckRows(const v1::MatrixHeader& header, uint64_t rows) {
  if (header.row_count() == rows) return absl::OkStatus();
  return absl::DataLossError(absl::StrCat(
      "the server announced ", header.row_count(), " rows instead of ", rows));
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
  Call call(options, request->mesh_digest());
  absl::Status status = ReadAnswer(
      &call, connection_->paths->ComputePaths(call.context(), *request),
      ReportTo(progress), take, [&answer] { return answer.paths.size(); },
      &answer.info);
  status.Update(CheckCount("paths", answer.paths.size(), query.targets.size()));
  if (!status.ok()) return status;
  if (!assembler.complete()) return EndedWithin("a path");
  return answer;
}

absl::StatusOr<IsolineAnswer> Client::ComputeIsolines(
    const IsolineQuery& query, const CallOptions& options,
    const SolveProgressCallback& progress) {
  auto request = MakeRequest<v1::ComputeIsolinesRequest>(query);
  if (!request.ok()) return request.status();
  request->mutable_levels()->Add(query.levels.begin(), query.levels.end());
  if (query.chord_error != 0) request->set_chord_error(query.chord_error);

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
  Call call(options, request->mesh_digest());
  absl::Status status = ReadAnswer(
      &call, connection_->paths->ComputeIsolines(call.context(), *request),
      ReportTo(progress), take, [&answer] { return answer.isolines.size(); },
      &answer.info);
  if (!status.ok()) return status;
  if (!assembler.complete()) return EndedWithin("an isoline");
  return answer;
}

absl::StatusOr<AnswerInfo> Client::ComputeMatrix(const MatrixQuery& query,
                                                 const MatrixReceiver& receiver,
                                                 const CallOptions& options) {
  auto request = MakeRequest<v1::ComputeMatrixRequest>(query);
  if (!request.ok()) return request.status();
  request->set_layout(query.sparse ? v1::MATRIX_LAYOUT_SPARSE
                                   : v1::MATRIX_LAYOUT_DENSE);

  const uint64_t rows = query.sources.size();
  uint64_t columns = 0;
  AnswerInfo info;
  RowAssembler assembler(query.value_type, query.sparse);
  const auto take = [&](const v1::ComputeMatrixResponse& response) {
    absl::Status status;
    if (response.has_header()) {
      columns = response.header().column_count();
      status = CheckRows(response.header(), rows);
      if (!status.ok() || receiver.on_shape == nullptr) return status;
      return receiver.on_shape({rows, columns});
    }
    if (!response.has_chunk()) return status;
    const v1::MatrixChunk& chunk = response.chunk();
    status =
        assembler.Consume({chunk.row(), chunk.value_count(), chunk.offset(),
                           chunk.columns(), chunk.values()},
                          columns);
    if (!status.ok() || !assembler.complete()) return status;
    return receiver.on_row(
        {assembler.row(), assembler.numbers(), assembler.values()});
  };
  Call call(options, request->mesh_digest());
  absl::Status status = ReadAnswer(
      &call, connection_->matrices->ComputeMatrix(call.context(), *request),
      ReportTo(receiver.on_progress, rows), take,
      [&assembler] { return assembler.row_count(); }, &info);
  status.Update(CheckCount("rows", assembler.row_count(), rows));
  if (!status.ok()) return status;
  return info;
}

absl::StatusOr<NearestAnswer> Client::FindNearest(
    const NearestQuery& query, const CallOptions& options,
    const CountProgressCallback& progress) {
  auto request = MakeRequest<v1::FindNearestRequest>(query);
  if (!request.ok()) return request.status();
  request->set_count(query.count);

  const uint64_t rows = query.sources.size();
  NearestAnswer answer;
  RowAssembler assembler(ValueType::kFloat64, /*has_numbers=*/true);
  const auto take = [&](const v1::FindNearestResponse& response) {
    if (response.has_header()) return CheckRows(response.header(), rows);
    if (!response.has_chunk()) return absl::OkStatus();
    const v1::NearestChunk& chunk = response.chunk();
    absl::Status status =
        assembler.Consume({chunk.row(), chunk.value_count(), chunk.offset(),
                           chunk.targets(), chunk.distances()},
                          query.targets.size());
    if (!status.ok() || !assembler.complete()) return status;
    std::vector<NearestTarget>& found = answer.found.emplace_back();
    for (size_t i = 0; i < assembler.values().size(); ++i) {
      found.push_back({assembler.numbers()[i], assembler.values()[i]});
    }
    return status;
  };
  Call call(options, request->mesh_digest());
  absl::Status status = ReadAnswer(
      &call, connection_->matrices->FindNearest(call.context(), *request),
      ReportTo(progress, rows), take, [&answer] { return answer.found.size(); },
      &answer.info);
  status.Update(CheckCount("rows", answer.found.size(), rows));
  if (!status.ok()) return status;
  return answer;
}

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
  Call call(options, request->mesh_digest());
  absl::Status status = ReadAnswer(
      &call,
      connection_->fields->SampleFarthestPoints(call.context(), *request),
      ReportTo(progress), take, [&answer] { return answer.samples.size(); },
      &answer.info);
  if (!status.ok()) return status;
  return answer;
}

absl::StatusOr<LogMap> Client::ComputeLogMap(
    const LogMapQuery& query, const CallOptions& options,
    const SolveProgressCallback& progress) {
  auto request = MakeRequest<v1::ComputeLogMapRequest>(query);
  if (!request.ok()) return request.status();
  *request->mutable_source() = codec::ToProto(query.source);

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
  Call call(options, request->mesh_digest());
  absl::Status status = ReadAnswer(
      &call, connection_->fields->ComputeLogMap(call.context(), *request),
      ReportTo(progress), take, [&map] { return map.coordinates.size(); },
      &map.info);
  status.Update(CheckCount("frames", has_frame ? 1 : 0, 1));
  status.Update(CheckCount("vertices of a log map", map.coordinates.size(),
                           map.info.vertex_count));
  if (!status.ok()) return status;
  return map;
}

}  // namespace geodesic::client
