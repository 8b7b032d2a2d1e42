#include "server/engine/field_cache.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace geodesic::server {
namespace {

bool IsVertex(const SurfacePoint& point) {
  return std::holds_alternative<VertexPoint>(point);
}

// What a field takes in the cache; known before it is computed.
uint64_t FieldBytes(const FieldKey& key, uint64_t vertices) {
  uint64_t curve_points = 0;
  for (const CurveSource& curve : key.curves) {
    curve_points += curve.points.size();
  }
  const uint64_t per_value = sizeof(double) + (key.trace ? sizeof(Arrival) : 0);
  return (vertices + key.targets.size()) * per_value +
         key.sources.size() * sizeof(Source) +
         key.curves.size() * sizeof(CurveSource) +
         (curve_points + key.targets.size()) * sizeof(SurfacePoint) +
         key.mesh_digest.size() + sizeof(FieldKey) + sizeof(DistanceField);
}

}  // namespace

bool Covers(const DistanceField& field, const FieldReach& reach) {
  if (field.settled_radius >= reach.radius) return true;
  if (!reach.LimitsTargets()) return false;
  // What is not certified is infinite.
  const auto certified = std::ranges::count_if(
      field.target_distances, [](double d) { return std::isfinite(d); });
  return static_cast<uint64_t>(certified) >= reach.targets;
}

bool VisitAnsweringKeys(const FieldKey& key,
                        absl::FunctionRef<bool(const FieldKey&)> visit) {
  if (visit(key)) return true;
  FieldKey other = key;
  // A traced field holds all that one without a trace does.
  if (!key.trace) {
    other.trace = true;
    if (visit(other)) return true;
  }
  // Distances at vertices are in every field that reaches far enough.
  if (!key.targets.empty() && std::ranges::all_of(key.targets, IsVertex)) {
    other.targets.clear();
    other.trace = key.trace;
    if (visit(other)) return true;
    other.trace = true;
    if (visit(other)) return true;
  }
  return false;
}

FieldCache::Found FieldCache::Find(const FieldKey& key,
                                   const FieldReach& reach) {
  Found found;
  VisitAnsweringKeys(key, [&](const FieldKey& candidate) {
    found.field = fields_.Find(candidate);
    if (found.field != nullptr && !Covers(*found.field, reach)) {
      found.field = nullptr;
    }
    if (found.field != nullptr) found.key = candidate;
    return found.field != nullptr;
  });
  return found;
}

absl::Status FieldCache::CheckCapacity(const FieldKey& key,
                                       uint64_t vertices) const {
  return fields_.CheckCapacity(FieldBytes(key, vertices));
}

absl::StatusOr<ByteReservation> FieldCache::Reserve(const FieldKey& key,
                                                    uint64_t vertices) {
  return fields_.Reserve(FieldBytes(key, vertices));
}

FieldHandle FieldCache::Insert(const FieldKey& key, DistanceField field,
                               ByteReservation room) {
  const double radius = field.settled_radius;
  return fields_
      .Insert(key, std::move(field), std::move(room),
              [radius](const DistanceField& present) {
                return present.settled_radius >= radius;
              })
      .value;
}

void FieldCache::EraseMesh(const std::string& digest) {
  fields_.EraseIf(
      [&](const FieldKey& key) { return key.mesh_digest == digest; });
}

}  // namespace geodesic::server
