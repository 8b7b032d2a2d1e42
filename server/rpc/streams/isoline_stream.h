// ComputeIsolines.

#ifndef GEODESIC_SERVER_RPC_STREAMS_ISOLINE_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_ISOLINE_STREAM_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "absl/status/statusor.h"
#include "codec/answer_writer.h"
#include "geodesic/isolines.h"
#include "geodesic/v1/question_service.pb.h"
#include "server/rpc/streams/job_question.h"

namespace geodesic::server {

class IsolineStream final
    : public JobQuestion<v1::ComputeIsolinesRequest, std::vector<Isoline>> {
 public:
  using JobQuestion::JobQuestion;

 private:
  absl::StatusOr<Work> MakeWork() override;
  void Announce() override;
  bool Put(const std::vector<Isoline>& isolines) override;

  // Set by Announce:
  std::optional<codec::LineWriter> lines_;
  uint32_t level_ = 0;
  uint32_t is_closed_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_ISOLINE_STREAM_H_
