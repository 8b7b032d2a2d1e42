// Questions whose answer the engine makes in rows: ComputeMatrix, FindNearest,
// ComputePairs and TraceLines.

#ifndef GEODESIC_SERVER_RPC_STREAMS_ROW_QUESTIONS_H_
#define GEODESIC_SERVER_RPC_STREAMS_ROW_QUESTIONS_H_

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "codec/answer_writer.h"
#include "geodesic/trace.h"
#include "geodesic/v1/question_service.pb.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/pairs/pair_order.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/answer_stream.h"
#include "server/rpc/messages/translation.h"

namespace geodesic::server {

// The next row is computed when one is taken, so a slow reader holds a few.
template <typename Request, typename EngineCall>
class RowQuestion : public AnswerStream<Request> {
 public:
  using AnswerStream<Request>::AnswerStream;

 protected:
  using AnswerStream<Request>::mutex_;

  virtual bool HasMoreRows() const ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) = 0;
  virtual void Take(const MatrixRow& row)
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) = 0;
  // Whether all that the last row made ready was put, as AnswerWriter::Put.
  virtual bool Put(const MatrixRow& row)
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) = 0;
  virtual uint64_t ItemsFinished() const
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) = 0;

  // What the engine calls when there may be a row.
  std::function<void()> OnRow() {
    return [self = this->Shared(this)] { self->SetNews(); };
  }

  void SetCall(EngineCall call) ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    call_ = std::move(call);
    this->SetHeader(*call_.mesh, call_.algorithm);
    // To which what the reader has is certified.
    if (this->is_resumed()) certified_error_ = this->tolerance();
  }
  // Constant once AskEngine has succeeded.
  const EngineCall& call() const { return call_; }

  void Cancel() final { call_.rows->Cancel(); }

 private:
  absl::StatusOr<NextMessage> FillBlocks() final
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    while (row_.has_value() || HasMoreRows()) {
      if (!row_.has_value()) {
        std::optional<absl::StatusOr<MatrixRow>> row = call_.rows->Take();
        if (!row.has_value()) {
          this->progress().set_items_finished(ItemsFinished());
          return NextMessage::kWait;
        }
        if (!row->ok()) return row->status();
        row_ = **std::move(row);
        certified_error_ = std::max(certified_error_, row_->certified_error);
        Take(*row_);
      }
      if (!Put(*row_)) return NextMessage::kSend;
      row_.reset();
    }
    this->SetCost(call_.rows->seconds(), call_.rows->windows_propagated(),
                  certified_error_);
    return NextMessage::kSendLast;
  }

  EngineCall call_;
  std::optional<MatrixRow> row_ ABSL_GUARDED_BY(mutex_);  // being put
  // Of the rows so far.
  double certified_error_ ABSL_GUARDED_BY(mutex_) = 0;
};

template <typename Request>
class RowStream final : public RowQuestion<Request, MatrixCall> {
 public:
  using RowQuestion<Request, MatrixCall>::RowQuestion;

 private:
  using RowQuestion<Request, MatrixCall>::mutex_;
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
    if (!is_sparse_ && request.resumption().received_size() > 0) {
      question.received_values = request.resumption().received(0);
    }
    absl::StatusOr<MatrixCall> call =
        this->engine().matrices().Compute(std::move(question), this->OnRow());
    if (!call.ok()) return call.status();
    MutexLock lock(mutex_);
    this->SetCall(*std::move(call));
    Announce();
    return absl::OkStatus();
  }

  void Announce() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    codec::AnswerWriter& writer = this->writer();
    const v1::ValueType type = this->value_type();
    const auto rows = static_cast<int64_t>(this->call().row_count);
    const auto columns = static_cast<int64_t>(this->call().column_count);
    if (is_sparse_) {
      row_end_ = writer.Announce("row_end", v1::VALUE_TYPE_UINT64, {rows});
      column_ = writer.Announce(kIsNearest ? "target" : "column",
                                v1::VALUE_TYPE_UINT32, {-1});
      distance_ = writer.Announce("distance", type, {-1});
    } else {
      distance_ = writer.Announce("distance", type, {rows, columns});
      rows_ = this->call().first_row;
      end_ = rows_ * this->call().column_count;
    }
  }

  bool HasMoreRows() const override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return rows_ < this->call().row_count;
  }
  uint64_t ItemsFinished() const override {
    return this->call().rows->rows_finished();
  }

  void Take(const MatrixRow& row) override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    ++rows_;
    first_ = end_;
    end_ += row.values.size();
  }

  bool Put(const MatrixRow& row) override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    codec::AnswerWriter& writer = this->writer();
    return (!is_sparse_ || (writer.PutOne(row_end_, rows_ - 1, end_) &&
                            writer.Put(column_, first_, row.columns))) &&
           writer.Put(distance_, first_, row.values);
  }

  // Set by AskEngine, then constant:
  bool is_sparse_ = false;
  uint32_t row_end_ = 0;
  uint32_t column_ = 0;
  uint32_t distance_ = 0;

  // That were taken, or left out.
  uint64_t rows_ ABSL_GUARDED_BY(mutex_) = 0;
  uint64_t first_ ABSL_GUARDED_BY(mutex_) = 0;  // value of the last of them
  uint64_t end_ ABSL_GUARDED_BY(mutex_) = 0;
};

using MatrixStream = RowStream<v1::ComputeMatrixRequest>;
using NearestStream = RowStream<v1::FindNearestRequest>;

class PairStream final : public RowQuestion<v1::ComputePairsRequest, PairCall> {
 public:
  using RowQuestion::RowQuestion;

 private:
  absl::Status AskEngine() override {
    PairRequest question;
    BeginQuestion(question);
    absl::Status status =
        AddPairs(request(), engine().limits(), question.pairs);
    if (!status.ok()) return status;
    question.paths = request().paths();
    absl::StatusOr<PairCall> call =
        engine().pairs().Compute(std::move(question), OnRow());
    if (!call.ok()) return call.status();
    MutexLock lock(mutex_);
    SetCall(*std::move(call));
    const auto pairs = static_cast<int64_t>(this->call().pair_count);
    order_.emplace(pairs);
    distance_ = writer().Announce("distance", value_type(), {pairs});
    if (request().paths()) lines_.emplace(writer(), pairs);
    return absl::OkStatus();
  }

  bool HasMoreRows() const override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return !order_->is_whole();
  }
  uint64_t ItemsFinished() const override {
    return call().work->answered.counts().all();
  }

  void Take(const MatrixRow& row) override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    order_->Add(row);
    next_path_ = 0;
    *trailer().mutable_pairs() = ToProto(call().work->answered.counts());
  }

  bool Put(const MatrixRow& row) override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    // Rows that have paths come in order.
    for (; next_path_ < row.paths.size(); ++next_path_) {
      const GeodesicPath& path = row.paths[next_path_];
      if (!lines_->Put(path.points, path.positions)) return false;
      lines_->Next();
    }
    return writer().Put(distance_, 0, order_->known());
  }

  uint32_t distance_ = 0;  // set by AskEngine, then constant

  // If paths were asked for.
  std::optional<codec::LineWriter> lines_ ABSL_GUARDED_BY(mutex_);
  std::optional<PairOrder> order_ ABSL_GUARDED_BY(mutex_);
  uint64_t next_path_ ABSL_GUARDED_BY(mutex_) = 0;  // of the last row
};

class TraceStream final : public RowQuestion<v1::TraceLinesRequest, LineCall> {
 public:
  using RowQuestion::RowQuestion;

 private:
  absl::Status AskEngine() override {
    LineRequest question;
    BeginQuestion(question);
    absl::StatusOr<LineQuestion> lines =
        ReadLines(request(), engine().limits());
    if (!lines.ok()) return lines.status();
    question.lines = *std::move(lines);
    absl::StatusOr<LineCall> call =
        engine().lines().Trace(std::move(question), OnRow());
    if (!call.ok()) return call.status();
    MutexLock lock(mutex_);
    SetCall(*std::move(call));
    const auto count = static_cast<int64_t>(this->call().line_count);
    lines_.emplace(writer(), count);
    length_ = writer().Announce("length", value_type(), {count});
    end_ = writer().Announce("end", v1::VALUE_TYPE_UINT8, {count});
    return absl::OkStatus();
  }

  bool HasMoreRows() const override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return lines_->line() < call().line_count;
  }
  uint64_t ItemsFinished() const override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return lines_->line();
  }

  void Take(const MatrixRow&) override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    next_ = 0;
  }

  bool Put(const MatrixRow& row) override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    for (; next_ < row.lines.size(); ++next_, lines_->Next()) {
      const TracedLine& line = row.lines[next_];
      if (!lines_->Put(line.points, line.positions) ||
          !writer().PutOne(length_, lines_->line(), line.length) ||
          !writer().PutOne(end_, lines_->line(),
                           static_cast<uint8_t>(line.end))) {
        return false;
      }
    }
    return true;
  }

  // Set by AskEngine, then constant:
  uint32_t length_ = 0;
  uint32_t end_ = 0;

  std::optional<codec::LineWriter> lines_ ABSL_GUARDED_BY(mutex_);
  uint64_t next_ ABSL_GUARDED_BY(mutex_) = 0;  // line of the row
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_ROW_QUESTIONS_H_
