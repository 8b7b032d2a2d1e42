#include "server/rpc/messages/field_chunks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "geodesic/field_quantities.h"
#include "server/rpc/messages/value_bytes.h"

namespace geodesic::server {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// 512 KiB a message: large enough to stream at the speed of memory, small
// enough that a stalled reader costs little.
constexpr uint64_t kValuesPerChunk = 65536;
// Distances, gradients and labels together are four times as large.
constexpr uint64_t kVerticesPerRichChunk = 16384;

}  // namespace

FieldChunks::FieldChunks(const FieldCall& call, FieldAnswer answer,
                         FieldExtras extras, v1::ValueType value_type,
                         uint64_t first_vertex)
    : call_(call),
      answer_(std::move(answer)),
      extras_(extras),
      value_type_(value_type),
      next_vertex_(first_vertex) {
  // What was sent before may have been cut, too.
  const std::span<const double> all = answer_.field->distances;
  if (std::isinf(call_.reach.radius)) return;
  for (const double distance : all.first(std::min(first_vertex, all.size()))) {
    Cut(distance);
  }
}

double FieldChunks::Cut(double distance) {
  if (distance <= call_.reach.radius) return distance;
  was_cut_ |= distance < kInfinity;
  return kInfinity;
}

bool FieldChunks::Next(v1::FieldChunk& chunk) {
  const std::span<const double> all = answer_.field->distances;
  if (next_vertex_ >= all.size()) return false;
  const uint64_t most =
      extras_.NeedTrace() ? kVerticesPerRichChunk : kValuesPerChunk;
  const std::span<const double> part =
      all.subspan(next_vertex_, std::min(most, all.size() - next_vertex_));
  chunk.set_offset(next_vertex_);
  if (std::isinf(call_.reach.radius)) {
    SetValues(part, value_type_, *chunk.mutable_distances());
  } else {
    values_.clear();
    for (const double distance : part) values_.push_back(Cut(distance));
    SetValues(values_, value_type_, *chunk.mutable_distances());
  }
  if (extras_.nearest_sources) {
    std::string& bytes = *chunk.mutable_nearest_sources();
    bytes.clear();
    for (size_t v = next_vertex_; v < next_vertex_ + part.size(); ++v) {
      const uint32_t source = answer_.derived->nearest_sources[v];
      AppendBytes(source == kNoSource || all[v] > call_.reach.radius
                      ? kNoSource
                      : call_.source_numbers[source],
                  bytes);
    }
  }
  if (extras_.gradients) {
    values_.clear();
    for (size_t v = next_vertex_; v < next_vertex_ + part.size(); ++v) {
      const Point gradient =
          all[v] > call_.reach.radius ? Point{} : answer_.derived->gradients[v];
      values_.insert(values_.end(), gradient.begin(), gradient.end());
    }
    SetValues(values_, value_type_, *chunk.mutable_gradients());
  }
  next_vertex_ += part.size();
  return true;
}

bool FieldChunks::NextTargets(v1::TargetChunk& chunk) {
  const std::vector<SurfacePoint>& targets = call_.query->targets;
  if (next_target_ >= targets.size()) return false;
  const uint64_t end =
      std::min<uint64_t>(next_target_ + kValuesPerChunk, targets.size());
  const bool has_all = answer_.field->target_distances.size() == targets.size();
  chunk.set_offset(next_target_);
  values_.clear();
  for (; next_target_ < end; ++next_target_) {
    const auto* vertex = std::get_if<VertexPoint>(&targets[next_target_]);
    const bool is_own = has_all || vertex == nullptr;
    values_.push_back(
        Cut(is_own ? answer_.field->target_distances[next_own_target_++]
                   : answer_.field->distances[vertex->vertex]));
  }
  SetValues(values_, value_type_, *chunk.mutable_distances());
  return true;
}

double FieldChunks::settled_radius() const {
  const double settled = answer_.field->settled_radius;
  // A whole field that lies within the radius has been sent whole.
  if (std::isinf(settled) && !was_cut_) return settled;
  return std::min(settled, call_.reach.radius);
}

}  // namespace geodesic::server
