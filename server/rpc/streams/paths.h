// ComputePaths.

#ifndef GEODESIC_SERVER_RPC_STREAMS_PATHS_H_
#define GEODESIC_SERVER_RPC_STREAMS_PATHS_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "codec/answer_writer.h"
#include "geodesic/path.h"
#include "geodesic/v1/question_service.pb.h"
#include "geodesic_types/field_path.h"
#include "geodesic_types/places.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/query_engine.h"
#include "server/rpc/messages/translation.h"
#include "server/rpc/streams/field_question.h"

namespace geodesic::server {

class PathStream final : public FieldQuestion<v1::ComputePathsRequest> {
 public:
  using FieldQuestion::FieldQuestion;

 private:
  absl::Status Translate(FieldRequest& question) override {
    question.extras.paths = true;
    absl::Status status =
        AddSources(request().sources(), engine().limits(), question.query);
    if (!status.ok()) return status;
    status = AddTargets(request().targets(), request().vertex_targets(),
                        engine().limits(), question.query);
    if (status.ok() && question.query.targets.empty()) {
      return InvalidField("targets", "targets is empty: name at least one");
    }
    question.reach.targets = question.query.targets.size();
    return status;
  }

  void Announce() override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    const auto targets = static_cast<int64_t>(call().query->targets.size());
    lines_.emplace(writer(), targets);
    source_ = writer().Announce("source", v1::VALUE_TYPE_UINT32, {targets});
    distance_ = writer().Announce("distance", value_type(), {targets});
    length_ = writer().Announce("length", value_type(), {targets});
  }

  void Cancel() override {
    FieldQuestion::Cancel();
    std::shared_ptr<RowPipeline> rows;
    {
      MutexLock lock(mutex_);
      rows = std::move(rows_);
    }
    if (rows != nullptr) rows->Cancel();
  }

  absl::StatusOr<NextMessage> FillFromField() override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    for (; lines_->line() < call().query->targets.size(); lines_->Next()) {
      if (path_ == nullptr) {
        absl::StatusOr<const GeodesicPath*> next = TakePath();
        if (!next.ok()) return next.status();
        if (*next == nullptr) return NextMessage::kWait;
        path_ = *next;
      }
      if (!Put(*path_)) return NextMessage::kSend;
      path_ = nullptr;
    }
    return NextMessage::kSendLast;
  }

  bool were_searched() const ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return !answer().derived->paths.has_value();
  }
  // Where paths are of equal length, a search may find another one.
  std::string Variant() const override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return were_searched() ? "s" : "t";
  }

  // The next path; null if it is not there yet. Those that were not searched
  // for are traced in jobs, which it starts.
  absl::StatusOr<const GeodesicPath*> TakePath()
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    if (were_searched()) return &answer().derived->found_paths[lines_->line()];
    if (rows_ == nullptr) {
      auto rows =
          engine().rows().TracePaths(call(), answer(), deadline(), requester(),
                                     [self = Shared(this)] { self->OnPath(); });
      if (!rows.ok()) return rows.status();
      rows_ = *std::move(rows);
    }
    if (next_in_row_ == row_.paths.size()) {
      std::optional<absl::StatusOr<AnswerRow>> row = rows_->Take();
      if (!row.has_value()) return nullptr;
      if (!row->ok()) return row->status();
      row_ = **std::move(row);
      next_in_row_ = 0;
    }
    return &row_.paths[next_in_row_++];
  }

  void OnPath() {
    MutexLock lock(mutex_);
    Advance();
  }

  // As AnswerWriter::Put.
  bool Put(const GeodesicPath& path) ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    const uint32_t source =
        path.points.empty() ? kNoSource : call().source_numbers[path.source];
    return lines_->Put(path.points, path.positions) &&
           writer().PutOne(source_, lines_->line(), source) &&
           writer().PutOne(distance_, lines_->line(), path.distance) &&
           writer().PutOne(length_, lines_->line(), path.length);
  }

  std::optional<codec::LineWriter> lines_ ABSL_GUARDED_BY(mutex_);
  // Arrays, set by Announce:
  uint32_t source_ = 0;
  uint32_t distance_ = 0;
  uint32_t length_ = 0;

  // Unless paths were searched for.
  std::shared_ptr<RowPipeline> rows_ ABSL_GUARDED_BY(mutex_);
  AnswerRow row_ ABSL_GUARDED_BY(mutex_);  // taken last
  size_t next_in_row_ ABSL_GUARDED_BY(mutex_) = 0;
  const GeodesicPath* path_ ABSL_GUARDED_BY(mutex_) = nullptr;  // being put
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_PATHS_H_
