// The finished fields.

#ifndef GEODESIC_SERVER_ENGINE_FIELD_CACHE_H_
#define GEODESIC_SERVER_ENGINE_FIELD_CACHE_H_

#include <cstdint>
#include <memory>

#include "geodesic/distance_field.h"
#include "server/engine/field_key.h"
#include "server/engine/lru_store.h"

namespace geodesic::server {

// Pins the field while it is held.
using FieldHandle = std::shared_ptr<const DistanceField>;

using FieldCache = LruStore<FieldKey, DistanceField>;

// What a field takes in the cache; known before it is computed.
inline uint64_t FieldBytes(const FieldKey& key, uint64_t vertices) {
  return vertices * sizeof(double) + key.sources.size() * sizeof(Source) +
         key.mesh_digest.size() + sizeof(FieldKey) + sizeof(DistanceField);
}

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELD_CACHE_H_
