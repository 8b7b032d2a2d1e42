// ComputePaths.

#ifndef GEODESIC_SERVER_RPC_STREAMS_PATH_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_PATH_STREAM_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "codec/answer_writer.h"
#include "geodesic/path.h"
#include "geodesic/v1/question_service.pb.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/rpc/streams/field_question.h"

namespace geodesic::server {

class PathStream final : public FieldQuestion<v1::ComputePathsRequest> {
 public:
  using FieldQuestion::FieldQuestion;

 private:
  absl::Status Translate(FieldRequest& question) override;
  void Announce() override;
  void Cancel() override;
  absl::StatusOr<NextMessage> FillFromField() override;
  // Where paths are of equal length, a search may find another one.
  std::string Variant() const override { return were_searched() ? "s" : "t"; }

  bool were_searched() const { return !answer().derived->paths.has_value(); }
  // The next path, if it is there: those that were not searched for are traced
  // in jobs, which it starts. Null: it is not there yet.
  absl::StatusOr<const GeodesicPath*> Next();

  // Set by Announce:
  std::optional<codec::LineWriter> lines_;
  uint32_t source_ = 0;
  uint32_t distance_ = 0;
  uint32_t length_ = 0;

  // Guarded by the stream's lock:
  std::shared_ptr<RowPipeline> rows_;  // unless paths were searched for
  MatrixRow row_;                      // whose paths are being put
  size_t next_in_row_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_PATH_STREAM_H_
