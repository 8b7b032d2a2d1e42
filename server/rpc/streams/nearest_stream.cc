#include "server/rpc/streams/nearest_stream.h"

namespace geodesic::server {

absl::Status NearestStream::Translate(MatrixRequest& question) const {
  question.nearest = request().count();
  return absl::OkStatus();
}

NearestStream::Chunk NearestStream::MakeChunk(v1::FindNearestResponse& message,
                                              uint64_t row,
                                              uint64_t value_count,
                                              uint64_t offset) const {
  auto& chunk = *message.mutable_chunk();
  chunk.set_row(row);
  chunk.set_value_count(value_count);
  chunk.set_offset(offset);
  return {chunk.mutable_targets(), chunk.mutable_distances()};
}

}  // namespace geodesic::server
