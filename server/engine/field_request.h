// A question about a field, and its answer.

#ifndef GEODESIC_SERVER_ENGINE_FIELD_REQUEST_H_
#define GEODESIC_SERVER_ENGINE_FIELD_REQUEST_H_

#include <cstdint>
#include <memory>
#include <string>

#include "geodesic/query.h"
#include "server/engine/clock.h"
#include "server/engine/derived_quantities.h"
#include "server/engine/field_cache.h"
#include "server/engine/field_key.h"
#include "server/engine/requester.h"
#include "server/engine/source_numbers.h"

namespace geodesic::server {

struct FieldRequest {
  std::string mesh_digest;
  Query query;
  // How the client numbers the query's sources.
  SourceNumbers numbers;
  FieldReach reach;
  FieldExtras extras;
  TimePoint deadline = kNoDeadline;
  Requester requester;
  // Only a field that is there already will do.
  bool must_be_kept = false;
};

enum class FieldOrigin {
  kSolved,
  kJoined,  // another request had started the computation
  kCached,
  kContinued,  // a computation that had stopped early went on
};

// Handles pin what they point to.
struct FieldAnswer {
  FieldHandle field;
  // What the field was solved for: at least what was asked.
  std::shared_ptr<const Query> query;
  // Null unless a quantity was asked for.
  std::shared_ptr<const DerivedQuantities> derived;
  FieldOrigin origin = FieldOrigin::kSolved;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELD_REQUEST_H_
