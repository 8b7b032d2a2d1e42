// Client::ComputeMatrix and FindNearest: rows off a server stream.

#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "answer_stream.h"
#include "connection.h"
#include "row_assembler.h"

namespace geodesic::client {
namespace {

// Handlers of an answer by rows. `check_header` sees the header, `consume` each
// chunk.
template <typename Response, typename CheckHeader, typename Consume>
auto RowHandlers(const NearestProgressCallback& callback, uint64_t rows,
                 CheckHeader check_header, Consume consume) {
  const auto progress = [&callback, rows](const v1::MatrixProgress& message,
                                          const AnswerInfo&) {
    if (callback != nullptr) callback(message.rows_finished(), rows);
  };
  const auto part = [consume](const Response& response) {
    return response.has_chunk() ? consume(response.chunk()) : absl::OkStatus();
  };
  return AnswerHandlers<CheckHeader, decltype(progress), decltype(part)>{
      check_header, progress, part};
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
  v1::ComputeMatrixRequest request;
  if (absl::Status status = SetCommon(query, &request); !status.ok()) {
    return status;
  }
  AddAll(query.sources, request.mutable_sources());
  AddAll(query.targets, request.mutable_targets());
  request.set_value_type(ToProto(query.value_type));
  if (query.radius.has_value()) {
    request.set_radius(*query.radius);
  }
  request.set_layout(query.sparse ? v1::MATRIX_LAYOUT_SPARSE
                                  : v1::MATRIX_LAYOUT_DENSE);

  const uint64_t rows = query.sources.size();
  uint64_t columns = 0;
  const auto header = [&](const v1::MatrixHeader& message) {
    absl::Status status = CheckRows(message, rows);
    if (!status.ok()) return status;
    columns = message.column_count();
    return receiver.on_shape == nullptr ? absl::OkStatus()
                                        : receiver.on_shape({rows, columns});
  };
  RowAssembler assembler(query.value_type, query.sparse);
  const auto consume = [&](const v1::MatrixChunk& chunk) {
    absl::Status status =
        assembler.Consume({chunk.row(), chunk.value_count(), chunk.offset(),
                           chunk.columns(), chunk.values()},
                          columns);
    if (!status.ok() || !assembler.complete()) return status;
    return receiver.on_row(
        {assembler.row(), assembler.numbers(), assembler.values()});
  };
  Call call(options);
  absl::StatusOr<AnswerInfo> info = ReadAnswer<v1::ComputeMatrixResponse>(
      &call, connection_->matrices->ComputeMatrix(call.context(), request),
      RowHandlers<v1::ComputeMatrixResponse>(receiver.on_progress, rows, header,
                                             consume),
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
  v1::FindNearestRequest request;
  if (absl::Status status = SetCommon(query, &request); !status.ok()) {
    return status;
  }
  AddAll(query.sources, request.mutable_sources());
  AddAll(query.targets, request.mutable_targets());
  request.set_count(query.count);
  if (query.radius.has_value()) {
    request.set_radius(*query.radius);
  }

  const uint64_t rows = query.sources.size();
  NearestAnswer answer;
  RowAssembler assembler(ValueType::kFloat64, /*has_numbers=*/true);
  const auto header = [rows](const v1::MatrixHeader& message) {
    return CheckRows(message, rows);
  };
  const auto consume = [&](const v1::NearestChunk& chunk) {
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
  absl::StatusOr<AnswerInfo> info = ReadAnswer<v1::FindNearestResponse>(
      &call, connection_->matrices->FindNearest(call.context(), request),
      RowHandlers<v1::FindNearestResponse>(progress, rows, header, consume),
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
