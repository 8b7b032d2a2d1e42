#include "server/rpc/streams/pair_stream.h"

#include <algorithm>
#include <utility>

#include "server/rpc/messages/translation.h"

namespace geodesic::server {

absl::Status PairStream::AskEngine() {
  PairRequest question;
  BeginQuestion(question);
  absl::Status status = AddPairs(request(), engine().limits(), question.pairs);
  if (!status.ok()) return status;
  question.paths = request().paths();
  absl::StatusOr<PairCall> call = engine().pairs().Compute(
      std::move(question), [self = Shared(this)] { self->SetNews(); });
  if (!call.ok()) return call.status();
  call_ = *std::move(call);
  SetHeader(*call_.mesh, call_.algorithm);
  const auto pairs = static_cast<int64_t>(call_.pair_count);
  distance_ = writer().Announce("distance", value_type(), {pairs});
  if (request().paths()) lines_.emplace(writer(), pairs);
  order_.emplace(call_.pair_count);
  // What pairs were certified to that the reader has.
  if (is_resumed()) certified_error_ = tolerance();
  return absl::OkStatus();
}

absl::StatusOr<NextMessage> PairStream::FillBlocks() {
  for (;;) {
    // Rows that have paths come in order.
    for (; next_path_ < row_.paths.size(); ++next_path_) {
      const GeodesicPath& path = row_.paths[next_path_];
      if (!lines_->Put(path.points, path.positions)) return NextMessage::kSend;
      lines_->Next();
    }
    if (!writer().Put(distance_, 0, order_->known())) return NextMessage::kSend;
    if (order_->is_whole()) break;
    std::optional<absl::StatusOr<MatrixRow>> row = call_.rows->Take();
    if (!row.has_value()) {
      progress().set_items_finished(call_.work->answered.counts().all());
      return NextMessage::kWait;
    }
    if (!row->ok()) return row->status();
    row_ = **std::move(row);
    next_path_ = 0;
    certified_error_ = std::max(certified_error_, row_.certified_error);
    order_->Add(row_);
  }
  SetCost(call_.rows->seconds(), call_.rows->windows_propagated(),
          certified_error_);
  const PairCounts counts = call_.work->answered.counts();
  v1::PairCounts& pairs = *trailer().mutable_pairs();
  pairs.set_searched(counts.searched);
  pairs.set_from_fields(counts.from_fields);
  pairs.set_from_cache(counts.from_cache);
  return NextMessage::kSendLast;
}

}  // namespace geodesic::server
