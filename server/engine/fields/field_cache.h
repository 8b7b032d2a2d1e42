// The cache of finished fields, and the keys by which equal questions are
// found. A field may be whole or end at a radius or a target.

#ifndef GEODESIC_SERVER_ENGINE_FIELDS_FIELD_CACHE_H_
#define GEODESIC_SERVER_ENGINE_FIELDS_FIELD_CACHE_H_

#include <compare>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "absl/functional/function_ref.h"
#include "geodesic/approximate/prepare.h"
#include "geodesic/distance_field.h"
#include "geodesic/valid_query.h"
#include "server/engine/base/lru_store.h"

namespace geodesic::server {

// Names a field: fields with equal keys have equal bits, as far as they reach.
// The tuning is part of it because it changes the statistics and the last bits.
struct FieldKey {
  std::string mesh_digest;
  ValidQuery query;  // sorted
  double bucket_width = 0;
  uint32_t max_batch = 0;
  // Apart from the tolerance of the query, which bounds the field's error.
  // Set if the field is approximate: no such field ever answers an exact
  // question, nor the other way round.
  std::optional<MethodChoice> method = {};

  friend auto operator<=>(const FieldKey&, const FieldKey&) = default;
};

// What may be asked of a field beside its distances.
struct FieldExtras {
  bool nearest_sources = false;
  bool gradients = false;
  bool log_map = false;
  bool paths = false;
  // The vertices in order of distance, sent while the field is computed.
  bool settled_order = false;
  // What is certified of each distance, which every field has; no job differs
  // for it.
  bool certified_errors = false;

  bool NeedTrace() const {
    return nearest_sources || gradients || log_map || paths;
  }
  bool Any() const { return NeedTrace() || settled_order; }

  friend auto operator<=>(const FieldExtras&, const FieldExtras&) = default;
};

// How much of a field is asked for: the search may end once one of these holds.
struct FieldReach {
  // Every distance up to this one is final.
  double radius = std::numeric_limits<double>::infinity();
  // This many of the key's targets are final.
  uint64_t targets = std::numeric_limits<uint64_t>::max();

  bool LimitsTargets() const {
    return targets != std::numeric_limits<uint64_t>::max();
  }

  friend auto operator<=>(const FieldReach&, const FieldReach&) = default;
};

// Questions that share one computation.
struct FieldJobKey {
  FieldKey field;
  FieldReach reach;
  FieldExtras extras;

  friend auto operator<=>(const FieldJobKey&, const FieldJobKey&) = default;
};

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

  // Whether the cache can ever hold the field. Errors: as Reserve.
  absl::Status CheckCapacity(const FieldKey& key, uint64_t vertices) const;

  // Makes room for a field before it is computed.
  // Errors: RESOURCE_EXHAUSTED naming the budget and the need.
  absl::StatusOr<ByteReservation> Reserve(const FieldKey& key,
                                          uint64_t vertices);

  // Keeps the field, or the one it has if that reaches further; returns it.
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
// first, until it returns true. Returns whether it did. A question with a
// tolerance is answered by fields within that tolerance and by exact ones; an
// exact question by exact fields alone.
bool VisitAnsweringKeys(const FieldKey& key,
                        absl::FunctionRef<bool(const FieldKey&)> visit);

// Whether the field holds what is asked for.
bool Covers(const DistanceField& field, const FieldReach& reach);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELDS_FIELD_CACHE_H_
