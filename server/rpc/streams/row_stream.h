// ComputeMatrix and FindNearest: header, progress, chunks in order of row,
// trailer.

#ifndef GEODESIC_SERVER_RPC_STREAMS_ROW_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_ROW_STREAM_H_

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/matrix_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/answer_stream.h"
#include "server/rpc/messages/translation.h"

namespace geodesic::server {

// The fields of a chunk that hold columns and values.
struct ChunkBytes {
  std::string& columns;
  std::string& values;
};
inline ChunkBytes BytesOf(v1::MatrixChunk& chunk) {
  return {*chunk.mutable_columns(), *chunk.mutable_values()};
}
inline ChunkBytes BytesOf(v1::NearestChunk& chunk) {
  return {*chunk.mutable_targets(), *chunk.mutable_distances()};
}

// The pipeline computes the next row only when one is taken, so a slow reader
// holds a few rows.
template <typename Request, typename Response>
class RowStream final : public AnswerStream<Request, Response> {
 public:
  using AnswerStream<Request, Response>::AnswerStream;

 private:
  static constexpr uint64_t kValuesPerChunk = 32768;

  absl::Status Ask() override {
    const Request& request = this->request();
    const Limits& limits = this->engine().limits();
    const absl::StatusOr<v1::ValueType> value_type =
        ResolveValueType(request.value_type());
    if (!value_type.ok()) return value_type.status();
    value_type_ = *value_type;
    MatrixRequest question;
    absl::Status status = this->BeginQuestion(question);
    if (!status.ok()) return status;
    if constexpr (requires { request.layout(); }) {
      question.filter.sparse = request.layout() == v1::MATRIX_LAYOUT_SPARSE;
      if (!question.filter.sparse &&
          request.layout() != v1::MATRIX_LAYOUT_DENSE &&
          request.layout() != v1::MATRIX_LAYOUT_UNSPECIFIED) {
        return Unknown("layout", request.layout());
      }
    } else {
      question.filter.nearest = request.count();
    }
    status = AddRows(request.sources(), request.vertex_sources(), limits,
                     question.query);
    if (status.ok()) {
      status = AddTargets(request.targets(), request.vertex_targets(), limits,
                          question.query);
    }
    if (!status.ok()) return status;
    if (request.has_radius()) question.filter.radius = request.radius();
    tolerance_ = question.query.tolerance;
    is_sparse_ = question.filter.sparse || question.filter.nearest.has_value();
    absl::StatusOr<MatrixCall> call = this->engine().matrices().Compute(
        std::move(question), [self = this->Shared(this)] {
          self->Update([&] { self->has_news_ = true; });
        });
    if (call.ok()) call_ = *std::move(call);
    return call.status();
  }

  void Cancel() override { call_.rows->Cancel(); }

  absl::StatusOr<NextMessage> Fill(Response& message) override {
    if (!std::exchange(has_header_, true)) {
      v1::MatrixHeader& header = *message.mutable_header();
      *header.mutable_answer() =
          MakeHeader(*call_.mesh, call_.algorithm, this->version(), tolerance_);
      header.set_row_count(call_.row_count);
      header.set_column_count(call_.column_count);
      header.set_value_type(value_type_);
      header.set_layout(is_sparse_ ? v1::MATRIX_LAYOUT_SPARSE
                                   : v1::MATRIX_LAYOUT_DENSE);
      return NextMessage::kSend;
    }
    if (!row_.has_value()) {
      if (next_row_ == call_.row_count) {
        *message.mutable_trailer() =
            MakeTrailer(call_.rows->seconds(), call_.rows->windows_propagated(),
                        next_row_, certified_error_);
        return NextMessage::kSendLast;
      }
      std::optional<absl::StatusOr<MatrixRow>> row = call_.rows->Take();
      if (!row.has_value()) {
        if (!std::exchange(has_news_, false)) return NextMessage::kWait;
        message.mutable_progress()->set_rows_finished(
            call_.rows->rows_finished());
        return NextMessage::kSend;
      }
      if (!row->ok()) return row->status();
      row_ = **std::move(row);
      certified_error_ = std::max(certified_error_, row_->certified_error);
      next_value_ = 0;
    }
    FillChunk(*message.mutable_chunk());
    return NextMessage::kSend;
  }

  template <typename Chunk>
  void FillChunk(Chunk& chunk) {
    const std::span<const double> values = row_->values;
    const std::span<const uint32_t> columns = row_->columns;  // dense: none
    const uint64_t count =
        std::min(kValuesPerChunk, values.size() - next_value_);
    chunk.set_row(next_row_);
    chunk.set_value_count(values.size());
    chunk.set_offset(next_value_);
    const ChunkBytes bytes = BytesOf(chunk);
    SetBytes(columns.empty() ? columns : columns.subspan(next_value_, count),
             bytes.columns);
    SetValues(values.subspan(next_value_, count), value_type_, bytes.values);
    this->entry().add_bytes(bytes.values.size());
    next_value_ += count;
    if (next_value_ == values.size()) {
      row_.reset();
      ++next_row_;
    }
  }

  // Set by Ask, then constant:
  MatrixCall call_;
  v1::ValueType value_type_ = v1::VALUE_TYPE_FLOAT64;
  bool is_sparse_ = false;
  double tolerance_ = 0;

  // Guarded by the stream's lock:
  bool has_header_ = false;
  bool has_news_ = false;  // a row was finished since the last progress
  uint64_t next_row_ = 0;
  std::optional<MatrixRow> row_;  // being sent
  uint64_t next_value_ = 0;       // of *row_
  double certified_error_ = 0;    // of the rows so far
};

using MatrixStream =
    RowStream<v1::ComputeMatrixRequest, v1::ComputeMatrixResponse>;
using NearestStream =
    RowStream<v1::FindNearestRequest, v1::FindNearestResponse>;

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_ROW_STREAM_H_
