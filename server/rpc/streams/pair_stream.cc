#include "server/rpc/streams/pair_stream.h"

#include <algorithm>
#include <utility>

namespace geodesic::server {

absl::Status PairStream::Ask() {
  const absl::StatusOr<v1::ValueType> value_type =
      ResolveValueType(request().value_type());
  if (!value_type.ok()) return value_type.status();
  value_type_ = *value_type;
  PairRequest question;
  absl::Status status = BeginQuestion(question);
  if (!status.ok()) return status;
  status = AddPairs(request(), engine().limits(), question.pairs);
  if (!status.ok()) return status;
  question.paths = request().paths();
  tolerance_ = question.tolerance;
  absl::StatusOr<PairCall> call = engine().pairs().Compute(
      std::move(question), [self = this->Shared(this)] {
        self->Update([&] { self->has_news_ = true; });
      });
  if (call.ok()) call_ = *std::move(call);
  return call.status();
}

absl::StatusOr<NextMessage> PairStream::Fill(
    v1::ComputePairsResponse& message) {
  if (!order_.has_value()) {
    order_.emplace(call_.pair_count);
    FillHeader(*message.mutable_header());
    return NextMessage::kSend;
  }
  if (next_path_ < row_.paths.size()) {
    FillPath(*message.mutable_path());
    return NextMessage::kSend;
  }
  if (order_->is_finished()) {
    FillTrailer(*message.mutable_trailer());
    return NextMessage::kSendLast;
  }
  while (!order_->has_next()) {
    std::optional<absl::StatusOr<MatrixRow>> row = call_.rows->Take();
    if (!row.has_value()) {
      if (!std::exchange(has_news_, false)) return NextMessage::kWait;
      message.mutable_progress()->set_pairs_finished(
          call_.work->answered.counts().all());
      return NextMessage::kSend;
    }
    if (!row->ok()) return row->status();
    row_ = **std::move(row);
    next_path_ = 0;
    certified_error_ = std::max(certified_error_, row_.certified_error);
    order_->Add(row_);
  }
  FillChunk(*message.mutable_chunk());
  return NextMessage::kSend;
}

void PairStream::FillHeader(v1::PairsHeader& header) {
  *header.mutable_answer() =
      MakeHeader(*call_.mesh, call_.algorithm, version(), tolerance_);
  header.set_pair_count(call_.pair_count);
  header.set_value_type(value_type_);
}

void PairStream::FillChunk(v1::PairsChunk& chunk) {
  chunk.set_offset(order_->taken());
  SetValues(order_->Take(kPairsPerChunk), value_type_,
            *chunk.mutable_distances());
  entry().add_bytes(chunk.distances().size());
}

void PairStream::FillPath(v1::PairPath& proto) {
  // Rows that have paths come in order, so the chunk was that of this row.
  proto.set_pair(row_.columns[next_path_]);
  const GeodesicPath& path = row_.paths[next_path_];
  next_point_ = SetPiece(path.points, path.positions, next_point_,
                         *proto.mutable_piece());
  entry().add_bytes(proto.piece().positions().size());
  if (next_point_ < path.points.size()) return;
  ++next_path_;
  next_point_ = 0;
}

void PairStream::FillTrailer(v1::PairsTrailer& trailer) {
  *trailer.mutable_answer() =
      MakeTrailer(call_.rows->seconds(), call_.rows->windows_propagated(),
                  order_->taken(), certified_error_);
  const PairCounts counts = call_.work->answered.counts();
  trailer.set_pairs_searched(counts.searched);
  trailer.set_pairs_from_fields(counts.from_fields);
  trailer.set_pairs_from_cache(counts.from_cache);
}

}  // namespace geodesic::server
