// TraceLines.

#ifndef GEODESIC_SERVER_RPC_STREAMS_TRACE_H_
#define GEODESIC_SERVER_RPC_STREAMS_TRACE_H_

#include <cstdint>
#include <optional>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "codec/answer_writer.h"
#include "geodesic/trace.h"
#include "geodesic/v1/question_service.pb.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/query_engine.h"
#include "server/rpc/streams/row_question.h"

namespace geodesic::server {

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
        engine().rows().TraceLines(std::move(question), OnRow());
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

  void Take(const AnswerRow&) override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    next_ = 0;
  }

  bool Put(const AnswerRow& row) override
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

#endif  // GEODESIC_SERVER_RPC_STREAMS_TRACE_H_
