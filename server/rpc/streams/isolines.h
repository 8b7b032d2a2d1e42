// ComputeIsolines.

#ifndef GEODESIC_SERVER_RPC_STREAMS_ISOLINES_H_
#define GEODESIC_SERVER_RPC_STREAMS_ISOLINES_H_

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "codec/answer_writer.h"
#include "geodesic/checkpoint.h"
#include "geodesic/isolines.h"
#include "geodesic/v1/question_service.pb.h"
#include "geodesic_types/field_path.h"
#include "server/engine/base/argument_checks.h"
#include "server/engine/query_engine.h"
#include "server/rpc/streams/job_question.h"

namespace geodesic::server {

class IsolineStream final
    : public JobQuestion<v1::ComputeIsolinesRequest, std::vector<Isoline>> {
 public:
  using JobQuestion::JobQuestion;

 private:
  absl::StatusOr<Work> MakeWork(
      std::shared_ptr<std::vector<Isoline>> result) override {
    absl::Status status = CheckRequest();
    if (!status.ok()) return status;
    IsolineOptions isolines{
        .levels = {request().levels().begin(), request().levels().end()},
        .chord_error = request().chord_error()};
    return [isolines = std::move(isolines), result = std::move(result)](
               const Mesh& mesh, const ValidQuery& query,
               const SolveOptions& options, Checkpoint& checkpoint,
               ByteReservation& memory) {
      absl::StatusOr<std::vector<Isoline>> found =
          geodesic::ComputeIsolines(mesh, query, isolines, options, checkpoint);
      if (!found.ok()) return found.status();
      absl::Status room = memory.GrowTo(BytesOf(*found));
      if (room.ok()) *result = *std::move(found);
      return room;
    };
  }

  absl::Status CheckRequest() {
    const auto& levels = request().levels();
    if (levels.empty()) {
      return InvalidField("levels", "levels is empty: name at least one");
    }
    for (int i = 0; i < levels.size(); ++i) {
      if (std::isfinite(levels[i]) && levels[i] > 0) continue;
      const std::string field = absl::StrCat("levels[", i, "]");
      return InvalidField(field, absl::StrCat(field, " is ", levels[i],
                                              "; it must be finite and > 0"));
    }
    if (!(request().chord_error() >= 0)) {
      return InvalidField("chord_error", absl::StrCat("chord_error is ",
                                                      request().chord_error(),
                                                      "; it must be a number "
                                                      ">= 0"));
    }
    return CheckCount("levels", levels.size(), "max_levels",
                      engine().limits().max_levels);
  }

  static uint64_t BytesOf(const std::vector<Isoline>& isolines) {
    uint64_t bytes = isolines.capacity() * sizeof(Isoline);
    for (const Isoline& isoline : isolines) {
      bytes += isoline.points.capacity() * sizeof(SurfacePoint) +
               isoline.positions.capacity() * sizeof(Point);
    }
    return bytes;
  }

  void Announce() override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    lines_.emplace(writer(), -1);
    level_ = writer().Announce("level", v1::VALUE_TYPE_FLOAT64, {-1});
    is_closed_ = writer().Announce("is_closed", v1::VALUE_TYPE_UINT8, {-1});
  }

  bool Put(const std::vector<Isoline>& isolines) override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    for (; lines_->line() < isolines.size(); lines_->Next()) {
      const uint64_t line = lines_->line();
      const Isoline& isoline = isolines[line];
      if (!lines_->Put(isoline.points, isoline.positions) ||
          !writer().PutOne(level_, line, isoline.level) ||
          !writer().PutOne<uint8_t>(is_closed_, line, isoline.is_closed)) {
        return false;
      }
    }
    return true;
  }

  std::optional<codec::LineWriter> lines_ ABSL_GUARDED_BY(mutex_);
  // Arrays, set by Announce:
  uint32_t level_ = 0;
  uint32_t is_closed_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_ISOLINES_H_
