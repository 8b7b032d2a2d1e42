// What makes two questions about a field the same.

#ifndef GEODESIC_SERVER_ENGINE_FIELDS_FIELD_KEY_H_
#define GEODESIC_SERVER_ENGINE_FIELDS_FIELD_KEY_H_

#include <compare>
#include <cstdint>
#include <limits>
#include <string>

#include "geodesic/valid_query.h"

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

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELDS_FIELD_KEY_H_
