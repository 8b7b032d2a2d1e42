// The finished fields, whole ones and those that end at a radius or a target.

#ifndef GEODESIC_SERVER_ENGINE_FIELDS_FIELD_CACHE_H_
#define GEODESIC_SERVER_ENGINE_FIELDS_FIELD_CACHE_H_

#include <cstdint>
#include <memory>
#include <optional>

#include "absl/functional/function_ref.h"
#include "geodesic/distance_field.h"
#include "server/engine/base/lru_store.h"
#include "server/engine/fields/field_key.h"

namespace geodesic::server {

// Pins the field while it is held.
using FieldHandle = std::shared_ptr<const DistanceField>;

// Thread-safe. See LruStore for what is kept and what is evicted.
class FieldCache {
 public:
  struct Found {
    FieldKey key;  // of the field, which may hold more than was asked for
    FieldHandle field;
  };

  explicit FieldCache(uint64_t capacity) : fields_("field cache", capacity) {}

  // A field that answers the question, if there is one.
  std::optional<Found> Find(const FieldKey& key, const FieldReach& reach);

  // Whether the field can ever be kept. Errors: as Reserve.
  absl::Status CheckCapacity(const FieldKey& key, uint64_t vertices) const;

  // Makes room for a field before it is computed.
  // Errors: RESOURCE_EXHAUSTED naming the budget and the need.
  absl::StatusOr<ByteReservation> Reserve(const FieldKey& key,
                                          uint64_t vertices);

  // Keeps the field unless one is there that reaches further; returns the one
  // that is handed out.
  FieldHandle Insert(const FieldKey& key, DistanceField field,
                     ByteReservation room);

  void EraseMesh(const std::string& digest);

  size_t size() const { return fields_.size(); }
  uint64_t used_bytes() const { return fields_.used_bytes(); }
  uint64_t evictions() const { return fields_.evictions(); }

 private:
  LruStore<FieldKey, DistanceField> fields_;
};

// Calls `visit` with the key of each field that may answer a question, the best
// first, until it returns true. Whether it did.
bool VisitAnsweringKeys(const FieldKey& key,
                        absl::FunctionRef<bool(const FieldKey&)> visit);

// Whether the field holds what is asked for.
bool Covers(const DistanceField& field, const FieldReach& reach);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELDS_FIELD_CACHE_H_
