#include "server/rpc/streams/path_stream.h"

#include <utility>

#include "geodesic/field_quantities.h"
#include "geodesic_types/field_path.h"
#include "server/rpc/messages/translation.h"

namespace geodesic::server {

absl::Status PathStream::Translate(FieldRequest& question) {
  question.extras.paths = true;
  absl::Status status =
      AddSources(request().sources(), engine().limits(), question.query);
  if (!status.ok()) return status;
  status = AddTargets(request().targets(), request().vertex_targets(),
                      engine().limits(), question.query);
  if (!status.ok()) return status;
  if (question.query.targets.empty()) {
    return InvalidField("targets", "targets is empty: name at least one");
  }
  question.reach.targets = question.query.targets.size();
  return absl::OkStatus();
}

void PathStream::Announce() {
  const auto targets = static_cast<int64_t>(call().query->targets.size());
  lines_.emplace(writer(), targets);
  source_ = writer().Announce("source", v1::VALUE_TYPE_UINT32, {targets});
  distance_ = writer().Announce("distance", value_type(), {targets});
  length_ = writer().Announce("length", value_type(), {targets});
}

void PathStream::Cancel() {
  FieldQuestion::Cancel();
  std::shared_ptr<RowPipeline> rows;
  Update([&] { rows = std::move(rows_); });
  if (rows != nullptr) rows->Cancel();
}

absl::StatusOr<const GeodesicPath*> PathStream::Next() {
  if (were_searched()) return &answer().derived->found_paths[lines_->line()];
  if (rows_ == nullptr) {
    auto rows =
        engine().TracePaths(call(), answer(), deadline(), requester(),
                            [self = Shared(this)] { self->Update([] {}); });
    if (!rows.ok()) return rows.status();
    rows_ = *std::move(rows);
  }
  if (next_in_row_ == row_.paths.size()) {
    std::optional<absl::StatusOr<MatrixRow>> row = rows_->Take();
    if (!row.has_value()) return nullptr;
    if (!row->ok()) return row->status();
    row_ = **std::move(row);
    next_in_row_ = 0;
  }
  return &row_.paths[next_in_row_];
}

absl::StatusOr<NextMessage> PathStream::FillFromField() {
  while (lines_->line() < call().query->targets.size()) {
    const absl::StatusOr<const GeodesicPath*> next = Next();
    if (!next.ok()) return next.status();
    if (*next == nullptr) return NextMessage::kWait;
    const GeodesicPath& path = **next;
    const uint64_t target = lines_->line();
    const uint32_t source =
        path.points.empty() ? kNoSource : call().source_numbers[path.source];
    if (!lines_->Put(path.points, path.positions) ||
        !writer().PutOne(source_, target, source) ||
        !writer().PutOne(distance_, target, path.distance) ||
        !writer().PutOne(length_, target, path.length)) {
      return NextMessage::kSend;
    }
    lines_->Next();
    ++next_in_row_;
  }
  return NextMessage::kSendLast;
}

}  // namespace geodesic::server
