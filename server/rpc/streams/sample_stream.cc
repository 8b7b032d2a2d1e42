#include "server/rpc/streams/sample_stream.h"

#include <algorithm>
#include <utility>

#include "geodesic/field_path.h"
#include "server/engine/base/argument_checks.h"

namespace geodesic::server {
namespace {

constexpr uint64_t kSamplesPerChunk = 16384;

}  // namespace

absl::StatusOr<SampleStream::Work> SampleStream::MakeWork() {
  const uint64_t count = request().count();
  if (count == 0) {
    return InvalidField("count", "count is 0; it must be at least 1");
  }
  absl::Status status = CheckCount("samples", count, "max_samples",
                                   engine().limits().max_samples);
  if (!status.ok()) return status;
  return [count](const Mesh& mesh, const ValidQuery& query,
                 const SolveOptions& options, Checkpoint& checkpoint,
                 ByteReservation& memory)
             -> absl::StatusOr<std::vector<FarthestSample>> {
    absl::Status room =
        memory.GrowTo(std::min<uint64_t>(count, mesh.vertex_count()) *
                      sizeof(FarthestSample));
    if (!room.ok()) return room;
    return geodesic::SampleFarthestPoints(
        mesh, query, static_cast<uint32_t>(count), options, checkpoint);
  };
}

absl::StatusOr<bool> SampleStream::FillPart(
    v1::SampleFarthestPointsResponse& message) {
  const uint64_t end =
      std::min<uint64_t>(next_sample_ + kSamplesPerChunk, result().size());
  if (next_sample_ == end) return false;
  v1::SampleChunk& chunk = *message.mutable_samples();
  chunk.clear_samples();
  for (; next_sample_ < end; ++next_sample_) {
    const FarthestSample& sample = result()[next_sample_];
    v1::FarthestSample& proto = *chunk.add_samples();
    proto.set_vertex(sample.vertex);
    proto.set_distance(sample.distance);
  }
  return true;
}

}  // namespace geodesic::server
