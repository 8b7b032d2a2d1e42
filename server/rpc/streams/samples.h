// SampleFarthestPoints.

#ifndef GEODESIC_SERVER_RPC_STREAMS_SAMPLES_H_
#define GEODESIC_SERVER_RPC_STREAMS_SAMPLES_H_

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/sampling.h"
#include "geodesic/v1/question_service.pb.h"
#include "geodesic_types/field_path.h"
#include "server/engine/base/argument_checks.h"
#include "server/engine/query_engine.h"
#include "server/rpc/streams/job_question.h"

namespace geodesic::server {

class SampleStream final : public JobQuestion<v1::SampleFarthestPointsRequest,
                                              std::vector<FarthestSample>> {
 public:
  using JobQuestion::JobQuestion;

 private:
  absl::StatusOr<Work> MakeWork(
      std::shared_ptr<std::vector<FarthestSample>> result) override {
    const uint64_t count = request().count();
    if (count == 0) {
      return InvalidField("count", "count is 0; it must be at least 1");
    }
    absl::Status status = CheckCount("samples", count, "max_samples",
                                     engine().limits().max_samples);
    if (!status.ok()) return status;
    return [count, result = std::move(result)](
               const Mesh& mesh, const ValidQuery& query,
               const SolveOptions& options, Checkpoint& checkpoint,
               ByteReservation& memory) {
      absl::Status room =
          memory.GrowTo(std::min<uint64_t>(count, mesh.vertex_count()) *
                        sizeof(FarthestSample));
      if (!room.ok()) return room;
      auto found = geodesic::SampleFarthestPoints(
          mesh, query, static_cast<uint32_t>(count), options, checkpoint);
      if (found.ok()) *result = *std::move(found);
      return found.status();
    };
  }

  void Announce() override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    vertex_ = writer().Announce("vertex", v1::VALUE_TYPE_UINT32, {-1});
    distance_ = writer().Announce("distance", value_type(), {-1});
  }

  bool Put(const std::vector<FarthestSample>& samples) override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return writer().Put(vertex_, 0, samples.size(), [&](uint64_t i) {
      return samples[i].vertex;
    }) && writer().Put(distance_, 0, samples.size(), [&](uint64_t i) {
      return samples[i].distance;
    });
  }

  // Arrays, set by Announce:
  uint32_t vertex_ = 0;
  uint32_t distance_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_SAMPLES_H_
