// ComputeLogMap.

#ifndef GEODESIC_SERVER_RPC_STREAMS_LOG_MAP_H_
#define GEODESIC_SERVER_RPC_STREAMS_LOG_MAP_H_

#include <cstdint>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "codec/places.h"
#include "geodesic/log_map.h"
#include "geodesic/v1/question_service.pb.h"
#include "server/rpc/messages/translation.h"
#include "server/rpc/streams/field_question.h"

namespace geodesic::server {

class LogMapStream final : public FieldQuestion<v1::ComputeLogMapRequest> {
 public:
  using FieldQuestion::FieldQuestion;

 private:
  absl::Status Translate(FieldRequest& question) override {
    question.extras.log_map = true;
    absl::StatusOr<SurfacePoint> source =
        codec::FromProto(request().source(), "source");
    if (source.ok()) question.query.sources = {{*source}};
    return source.status();
  }

  void Announce() override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    zero_direction_ =
        writer().Announce("zero_direction", v1::VALUE_TYPE_FLOAT64, {3});
    coordinates_ = writer().Announce("coordinates", value_type(),
                                     {call().mesh->mesh->vertex_count(), 2});
  }

  absl::StatusOr<NextMessage> FillFromField() override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    const LogMap& map = answer().derived->log_map;
    return writer().Put(zero_direction_, 0, map.zero_direction) &&
                   writer().Put(coordinates_, 0, 2 * map.coordinates.size(),
                                [&](uint64_t i) {
                                  return map.coordinates[i / 2][i % 2];
                                })
               ? NextMessage::kSendLast
               : NextMessage::kSend;
  }

  // Arrays, set by Announce:
  uint32_t zero_direction_ = 0;
  uint32_t coordinates_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_LOG_MAP_H_
