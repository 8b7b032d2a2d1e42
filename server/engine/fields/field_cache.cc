#include "server/engine/fields/field_cache.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace geodesic::server {
namespace {

// The points of all curves together.
uint64_t CurvePoints(const Query& query) {
  uint64_t points = 0;
  for (const Source& source : query.sources) {
    const auto* curve = std::get_if<Curve>(&source.place);
    if (curve != nullptr) points += curve->points.size();
  }
  return points;
}

// The bytes a field takes in the cache, which are known before it is computed.
uint64_t FieldBytes(const FieldKey& key, uint64_t vertices) {
  const Query& query = *key.query;
  const uint64_t per_value = sizeof(double) +
                             (query.trace ? sizeof(Arrival) : 0) +
                             (query.tolerance > 0 ? sizeof(float) : 0);
  return (vertices + query.targets.size()) * per_value +
         query.sources.size() * sizeof(Source) +
         (CurvePoints(query) + query.targets.size()) * sizeof(SurfacePoint) +
         key.mesh_digest.size() + sizeof(FieldKey) + sizeof(Query) +
         sizeof(DistanceField);
}

}  // namespace

bool Covers(const DistanceField& field, const FieldReach& reach) {
  if (field.settled_radius >= reach.radius) return true;
  if (!reach.LimitsTargets()) return false;
  // A distance that is not certified is infinite.
  const auto certified = std::ranges::count_if(
      field.target_distances, [](double d) { return std::isfinite(d); });
  return static_cast<uint64_t>(certified) >= reach.targets;
}

bool VisitAnsweringKeys(const FieldKey& key,
                        absl::FunctionRef<bool(const FieldKey&)> visit) {
  if (visit(key)) return true;
  FieldKey other = key;
  const auto visit_other = [&](ValidQuery query) {
    other.query = std::move(query);
    return visit(other);
  };
  const ValidQuery& asked = key.query;
  const bool has_vertex_targets_alone =
      !asked->targets.empty() && asked.WithoutVertexTargets()->targets.empty();
  const ValidQuery exact = asked.WithoutTolerance();
  if (asked->tolerance > 0 && ((has_vertex_targets_alone &&
                                visit_other(asked.WithoutVertexTargets())) ||
                               visit_other(exact))) {
    return true;
  }
  // A traced field holds everything that an untraced one does, and is exact.
  const auto visit_traced = [&](const ValidQuery& query) {
    return !query->trace && visit_other(query.WithTrace(true));
  };
  if (visit_traced(exact)) return true;
  // Distances at vertices are in every field that reaches far enough.
  if (!has_vertex_targets_alone) return false;
  const ValidQuery fewer = exact.WithoutVertexTargets();
  return visit_other(fewer) || visit_traced(fewer);
}

std::optional<FieldCache::Found> FieldCache::Find(const FieldKey& key,
                                                  const FieldReach& reach) {
  std::optional<Found> found;
  VisitAnsweringKeys(key, [&](const FieldKey& candidate) {
    FieldHandle field = fields_.Find(candidate);
    if (field != nullptr && Covers(*field, reach)) {
      found = {candidate, std::move(field)};
    }
    return found.has_value();
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
