// A question about a field, and its answer.

#ifndef GEODESIC_SERVER_ENGINE_FIELDS_FIELD_REQUEST_H_
#define GEODESIC_SERVER_ENGINE_FIELDS_FIELD_REQUEST_H_

#include <cstdint>
#include <memory>
#include <string>

#include "geodesic/query.h"
#include "server/engine/base/clock.h"
#include "server/engine/base/requester.h"
#include "server/engine/fields/derived_quantities.h"
#include "server/engine/fields/field_cache.h"
#include "server/engine/fields/field_key.h"

namespace geodesic::server {

struct FieldRequest {
  std::string mesh_digest;
  Query query;
  FieldReach reach;
  FieldExtras extras;
  TimePoint deadline = kNoDeadline;
  Requester requester;
  // Only a field that is there already will do.
  bool must_be_kept = false;
};

enum class FieldOrigin {
  kComputed,
  kJoined,  // another request had started the computation
  kCached,
};

// Handles pin what they point to. The field was solved for what was asked, or
// more.
struct FieldAnswer {
  FieldHandle field;
  // Null unless a quantity was asked for.
  std::shared_ptr<const DerivedQuantities> derived;
  FieldOrigin origin = FieldOrigin::kComputed;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELDS_FIELD_REQUEST_H_
