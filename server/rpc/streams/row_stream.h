// What the streams of rows share: header, progress, chunks in order of row,
// trailer.

#ifndef GEODESIC_SERVER_RPC_STREAMS_ROW_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_ROW_STREAM_H_

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/matrix_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/answer_stream.h"
#include "server/rpc/messages/field_translation.h"
#include "server/rpc/messages/surface_translation.h"
#include "server/rpc/messages/value_bytes.h"

namespace geodesic::server {

// A derived class says what to ask and how a chunk looks.
//
// The pipeline computes the next row only when one is taken, so a slow reader
// holds a few rows.
template <typename Request, typename Response>
class RowStream : public AnswerStream<Request, Response>, public RowObserver {
 public:
  using AnswerStream<Request, Response>::AnswerStream;

  void OnRow() final {
    this->Update([this] { has_news_ = true; });
  }

 protected:
  // Adds to `question` what only this stream knows.
  virtual absl::Status Translate(MatrixRequest& question) const = 0;

  // A chunk's parts, to be filled.
  struct Chunk {
    std::string* columns;
    std::string* values;
  };
  virtual Chunk MakeChunk(Response& message, uint64_t row, uint64_t value_count,
                          uint64_t offset) const = 0;

 private:
  static constexpr uint64_t kValuesPerChunk = 32768;

  absl::Status Ask() final {
    const Request& request = this->request();
    const Limits& limits = this->engine().limits();
    const absl::StatusOr<v1::ValueType> value_type =
        ResolveValueType(request.value_type());
    if (!value_type.ok()) return value_type.status();
    value_type_ = *value_type;
    MatrixRequest question;
    absl::Status status = this->BeginQuestion(question);
    if (status.ok()) status = Translate(question);
    if (status.ok()) {
      status = AddRows(request.sources(), limits, question.query);
    }
    if (!status.ok()) return status;
    absl::StatusOr<std::vector<SurfacePoint>> targets =
        TargetsFromProto(request.targets(), limits);
    if (!targets.ok()) return targets.status();
    question.query.targets = *std::move(targets);
    if (request.has_radius()) question.radius = request.radius();
    is_sparse_ = question.sparse || question.nearest.has_value();
    absl::StatusOr<MatrixCall> call =
        this->engine().ComputeMatrix(std::move(question), this->Shared(this));
    if (!call.ok()) return call.status();
    call_ = *std::move(call);
    return absl::OkStatus();
  }

  void Cancel() final { call_.rows->Cancel(); }

  absl::StatusOr<NextMessage> Fill(Response& message) final {
    if (!std::exchange(has_header_, true)) {
      v1::MatrixHeader& header = *message.mutable_header();
      *header.mutable_answer() =
          MakeHeader(*call_.mesh, call_.algorithm, this->version());
      header.set_row_count(call_.row_count);
      header.set_column_count(call_.column_count);
      header.set_value_type(value_type_);
      header.set_layout(is_sparse_ ? v1::MATRIX_LAYOUT_SPARSE
                                   : v1::MATRIX_LAYOUT_DENSE);
      return NextMessage::kSend;
    }
    if (!row_.has_value()) {
      if (next_row_ == call_.row_count) {
        v1::AnswerTrailer& trailer = *message.mutable_trailer();
        trailer.set_compute_seconds(call_.rows->seconds());
        trailer.set_windows_propagated(call_.rows->windows_propagated());
        trailer.set_item_count(next_row_);
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
      next_value_ = 0;
    }
    FillChunk(message);
    return NextMessage::kSend;
  }

  void FillChunk(Response& message) {
    const uint64_t size = row_->values.size();
    const uint64_t count = std::min(kValuesPerChunk, size - next_value_);
    const Chunk chunk = MakeChunk(message, next_row_, size, next_value_);
    if (chunk.columns != nullptr) {
      SetBytes(
          std::span<const uint32_t>(row_->columns)
              .subspan(is_sparse_ ? next_value_ : 0, is_sparse_ ? count : 0),
          *chunk.columns);
    }
    SetValues(std::span<const double>(row_->values).subspan(next_value_, count),
              value_type_, *chunk.values);
    this->entry().add_bytes(chunk.values->size());
    next_value_ += count;
    if (next_value_ == size) {
      row_.reset();
      ++next_row_;
    }
  }

  // Set by Ask, then constant:
  MatrixCall call_;
  v1::ValueType value_type_ = v1::VALUE_TYPE_FLOAT64;
  bool is_sparse_ = false;

  // Guarded by the stream's lock:
  bool has_header_ = false;
  bool has_news_ = false;  // a row was finished since the last progress
  uint64_t next_row_ = 0;
  std::optional<MatrixRow> row_;  // on its way
  uint64_t next_value_ = 0;       // of *row_
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_ROW_STREAM_H_
