// The finished fields, whole ones and those that end at a radius or a target,
// and what makes two questions about a field the same.

#ifndef GEODESIC_SERVER_ENGINE_FIELDS_FIELD_CACHE_H_
#define GEODESIC_SERVER_ENGINE_FIELDS_FIELD_CACHE_H_

#include <compare>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "absl/functional/function_ref.h"
#include "geodesic/distance_field.h"
#include "geodesic/valid_query.h"
#include "server/engine/base/lru_store.h"

namespace geodesic::server {

// Names a field: equal keys have equal bits, as far as the fields reach. The
// tuning is part of it because it changes the statistics and the last bits.
struct FieldKey {
  std::string mesh_digest;
  ValidQuery query;  // sorted
  double bucket_width = 0;
  uint32_t max_batch = 0;

  friend auto operator<=>(const FieldKey&, const FieldKey&) = default;
};

// What else may be asked of a field.
struct FieldExtras {
  bool nearest_sources = false;
  bool gradients = false;
  bool log_map = false;
  bool paths = false;
  // The vertices in order of distance, while the field is computed.
  bool settled_order = false;

  bool NeedTrace() const {
    return nearest_sources || gradients || log_map || paths;
  }
  bool Any() const { return NeedTrace() || settled_order; }

  friend auto operator<=>(const FieldExtras&, const FieldExtras&) = default;
};

// How much of a field is asked for: enough as soon as one of these holds.
struct FieldReach {
  // Every distance up to here is there.
  double radius = std::numeric_limits<double>::infinity();
  // So many of the key's targets are there.
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
