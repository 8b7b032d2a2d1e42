#include "server/rpc/streams/log_map_stream.h"

#include <algorithm>
#include <utility>

#include "server/rpc/messages/surface_translation.h"
#include "server/rpc/messages/value_bytes.h"

namespace geodesic::server {
namespace {

constexpr uint64_t kVerticesPerChunk = 32768;

}  // namespace

absl::Status LogMapStream::Translate(FieldRequest& question) {
  const absl::StatusOr<v1::ValueType> value_type =
      ResolveValueType(request().value_type());
  if (!value_type.ok()) return value_type.status();
  value_type_ = *value_type;
  question.extras.log_map = true;
  absl::StatusOr<SurfacePoint> source = FromProto(request().source(), "source");
  if (!source.ok()) return source.status();
  question.query.sources = {{*source}};
  return absl::OkStatus();
}

absl::StatusOr<bool> LogMapStream::FillPart(
    v1::ComputeLogMapResponse& message) {
  const LogMap& map = answer().derived->log_map;
  if (!std::exchange(has_frame_, true)) {
    v1::Point& direction = *message.mutable_frame()->mutable_zero_direction();
    direction.set_x(map.zero_direction[0]);
    direction.set_y(map.zero_direction[1]);
    direction.set_z(map.zero_direction[2]);
    return true;
  }
  const uint64_t end = std::min<uint64_t>(next_vertex_ + kVerticesPerChunk,
                                          map.coordinates.size());
  if (next_vertex_ == end) return false;
  v1::LogMapChunk& chunk = *message.mutable_chunk();
  chunk.set_offset(next_vertex_);
  values_.clear();
  for (; next_vertex_ < end; ++next_vertex_) {
    const auto& uv = map.coordinates[next_vertex_];
    values_.insert(values_.end(), uv.begin(), uv.end());
  }
  SetValues(values_, value_type_, *chunk.mutable_coordinates());
  entry().add_bytes(chunk.coordinates().size());
  return true;
}

}  // namespace geodesic::server
