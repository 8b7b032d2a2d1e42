// ComputePairs.

#ifndef GEODESIC_SERVER_RPC_STREAMS_PAIRS_H_
#define GEODESIC_SERVER_RPC_STREAMS_PAIRS_H_

#include <cstdint>
#include <optional>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "codec/answer_writer.h"
#include "geodesic/path.h"
#include "geodesic/v1/question_service.pb.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/query_engine.h"
#include "server/engine/rows/pair_order.h"
#include "server/rpc/messages/translation.h"
#include "server/rpc/streams/row_question.h"

namespace geodesic::server {

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
        engine().rows().ComputePairs(std::move(question), OnRow());
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

  void Take(const AnswerRow& row) override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    order_->Add(row);
    next_path_ = 0;
    *trailer().mutable_pairs() = ToProto(call().work->answered.counts());
  }

  bool Put(const AnswerRow& row) override
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

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_PAIRS_H_
