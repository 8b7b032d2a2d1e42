// Client::ComputeMatrix and FindNearest: rows off a server stream.

#include <utility>

#include "absl/strings/str_cat.h"
#include "answer_stream.h"
#include "assemblers.h"
#include "connection.h"

namespace geodesic::client {
namespace {

// Takes the progress of `rows` computations for a callback, which may be empty.
auto ReportTo(const NearestProgressCallback& callback, uint64_t rows) {
  return
      [&callback, rows](const v1::MatrixProgress& message, const AnswerInfo&) {
        if (callback != nullptr) callback(message.rows_finished(), rows);
      };
}

absl::Status CheckRows(const v1::MatrixHeader& header, uint64_t rows) {
  return header.row_count() == rows
             ? absl::OkStatus()
             : absl::DataLossError(absl::StrCat("the server announced ",
                                                header.row_count(),
                                                " rows instead of ", rows));
}

}  // namespace

absl::StatusOr<AnswerInfo> Client::ComputeMatrix(const MatrixQuery& query,
                                                 const MatrixReceiver& receiver,
                                                 const CallOptions& options) {
  auto request = MakeRequest<v1::ComputeMatrixRequest>(query);
  if (!request.ok()) return request.status();
  request->set_layout(query.sparse ? v1::MATRIX_LAYOUT_SPARSE
                                   : v1::MATRIX_LAYOUT_DENSE);

  const uint64_t rows = query.sources.size();
  uint64_t columns = 0;
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
  Call call(options);
  absl::StatusOr<AnswerInfo> info = ReadAnswer(
      &call, connection_->matrices->ComputeMatrix(call.context(), *request),
      ReportTo(receiver.on_progress, rows), take,
      [&assembler] { return assembler.row_count(); });
  if (info.ok() && assembler.row_count() != rows) {
    return absl::DataLossError(absl::StrCat(
        "the server sent ", assembler.row_count(), " of ", rows, " rows"));
  }
  return info;
}

absl::StatusOr<NearestAnswer> Client::FindNearest(
    const NearestQuery& query, const CallOptions& options,
    const NearestProgressCallback& progress) {
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
  Call call(options);
  absl::StatusOr<AnswerInfo> info = ReadAnswer(
      &call, connection_->matrices->FindNearest(call.context(), *request),
      ReportTo(progress, rows), take,
      [&answer] { return answer.found.size(); });
  if (!info.ok()) return info.status();
  if (answer.found.size() != rows) {
    return absl::DataLossError(absl::StrCat(
        "the server sent ", answer.found.size(), " of ", rows, " rows"));
  }
  answer.info = *std::move(info);
  return answer;
}

}  // namespace geodesic::client
