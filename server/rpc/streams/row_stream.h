// ComputeMatrix and FindNearest.

#ifndef GEODESIC_SERVER_RPC_STREAMS_ROW_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_ROW_STREAM_H_

#include <algorithm>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/question_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/answer_stream.h"
#include "server/rpc/messages/translation.h"

namespace geodesic::server {

// The pipeline computes the next row only when one is taken, so a slow reader
// holds a few rows.
template <typename Request>
class RowStream final : public AnswerStream<Request> {
 public:
  using AnswerStream<Request>::AnswerStream;

 private:
  static constexpr bool kIsNearest =
      std::is_same_v<Request, v1::FindNearestRequest>;

  absl::Status AskEngine() override {
    const Request& request = this->request();
    const Limits& limits = this->engine().limits();
    MatrixRequest question;
    this->BeginQuestion(question);
    if constexpr (kIsNearest) {
      question.filter.nearest = request.count();
    } else {
      question.filter.sparse = request.layout() == v1::MATRIX_LAYOUT_SPARSE;
      if (!v1::MatrixLayout_IsValid(request.layout())) {
        return Unknown("layout", request.layout());
      }
    }
    absl::Status status = AddRows(request.sources(), request.vertex_sources(),
                                  limits, question.query);
    if (status.ok()) {
      status = AddTargets(request.targets(), request.vertex_targets(), limits,
                          question.query);
    }
    if (!status.ok()) return status;
    if (request.has_radius()) question.filter.radius = request.radius();
    is_sparse_ = kIsNearest || question.filter.sparse;
    absl::StatusOr<MatrixCall> call = this->engine().matrices().Compute(
        std::move(question), [self = this->Shared(this)] { self->SetNews(); });
    if (!call.ok()) return call.status();
    call_ = *std::move(call);
    this->SetHeader(*call_.mesh, call_.algorithm);
    Announce();
    // What rows were certified to that the reader has.
    if (this->is_resumed()) certified_error_ = this->tolerance();
    return absl::OkStatus();
  }

  void Announce() {
    const auto rows = static_cast<int64_t>(call_.row_count);
    const auto columns = static_cast<int64_t>(call_.column_count);
    if (!is_sparse_) {
      distance_ = this->writer().Announce("distance", this->value_type(),
                                          {rows, columns});
      return;
    }
    row_end_ =
        this->writer().Announce("row_end", v1::VALUE_TYPE_UINT64, {rows});
    column_ = this->writer().Announce(kIsNearest ? "target" : "column",
                                      v1::VALUE_TYPE_UINT32, {-1});
    distance_ = this->writer().Announce("distance", this->value_type(), {-1});
  }

  void Cancel() override { call_.rows->Cancel(); }

  absl::StatusOr<NextMessage> FillBlocks() override {
    for (; next_row_ < call_.row_count; ++next_row_) {
      if (!row_.has_value()) {
        std::optional<absl::StatusOr<MatrixRow>> row = call_.rows->Take();
        if (!row.has_value()) {
          this->progress().set_items_finished(call_.rows->rows_finished());
          return NextMessage::kWait;
        }
        if (!row->ok()) return row->status();
        row_ = **std::move(row);
        certified_error_ = std::max(certified_error_, row_->certified_error);
      }
      if (!PutRow()) return NextMessage::kSend;
      first_ += row_->values.size();
      row_.reset();
    }
    this->SetCost(call_.rows->seconds(), call_.rows->windows_propagated(),
                  certified_error_);
    return NextMessage::kSendLast;
  }

  // As AnswerWriter::Put.
  bool PutRow() {
    return (!is_sparse_ ||
            (this->writer().PutOne(row_end_, next_row_,
                                   first_ + row_->values.size()) &&
             this->writer().Put(column_, first_, row_->columns))) &&
           this->writer().Put(distance_, first_, row_->values);
  }

  // Set by AskEngine, then constant:
  MatrixCall call_;
  bool is_sparse_ = false;
  // Arrays:
  uint32_t row_end_ = 0;
  uint32_t column_ = 0;
  uint32_t distance_ = 0;

  // Guarded by the stream's lock:
  uint64_t next_row_ = 0;
  uint64_t first_ = 0;            // value of that row
  std::optional<MatrixRow> row_;  // being put
  double certified_error_ = 0;    // of the rows so far
};

using MatrixStream = RowStream<v1::ComputeMatrixRequest>;
using NearestStream = RowStream<v1::FindNearestRequest>;

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_ROW_STREAM_H_
