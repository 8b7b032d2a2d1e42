// Questions whose answer the engine makes in rows: ComputeMatrix, FindNearest,
// ComputePairs and TraceLines.

#ifndef GEODESIC_SERVER_RPC_STREAMS_ROW_QUESTION_H_
#define GEODESIC_SERVER_RPC_STREAMS_ROW_QUESTION_H_

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "absl/status/statusor.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/rpc/calls/answer_stream.h"

namespace geodesic::server {

// The next row is computed when one is taken, so a slow reader holds a few.
template <typename Request, typename EngineCall>
class RowQuestion : public AnswerStream<Request> {
 public:
  using AnswerStream<Request>::AnswerStream;

 protected:
  using AnswerStream<Request>::mutex_;

  virtual bool HasMoreRows() const ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) = 0;
  virtual void Take(const AnswerRow& row)
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) = 0;
  // Whether all that the last row made ready was put, as AnswerWriter::Put.
  virtual bool Put(const AnswerRow& row)
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
        std::optional<absl::StatusOr<AnswerRow>> row = call_.rows->Take();
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
  std::optional<AnswerRow> row_ ABSL_GUARDED_BY(mutex_);  // being put
  // Of the rows so far.
  double certified_error_ ABSL_GUARDED_BY(mutex_) = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_ROW_QUESTION_H_
