// What is made from a traced field, once it is there.

#ifndef GEODESIC_SERVER_ENGINE_FIELDS_DERIVED_QUANTITIES_H_
#define GEODESIC_SERVER_ENGINE_FIELDS_DERIVED_QUANTITIES_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/log_map.h"
#include "geodesic/path.h"
#include "geodesic/valid_query.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/fields/field_cache.h"
#include "server/engine/fields/field_key.h"
#include "server/engine/meshes/mesh_store.h"

namespace geodesic::server {

// As far as it was asked for. Sources are numbered as the field's query does.
struct DerivedQuantities {
  ByteReservation memory;
  // Pinned for the tracer.
  MeshHandle mesh;
  FieldHandle field;

  // Per vertex:
  std::vector<uint32_t> nearest_sources;
  std::vector<Point> gradients;
  LogMap log_map;

  std::optional<PathTracer> paths;
};

// What it takes: memory that Derive is to be given.
uint64_t DerivedBytes(const FieldExtras& extras, uint64_t vertices);

// Log maps end at `radius`. O(V), and for a log map the edges that its paths
// cross.
// REQUIRES: `field` was solved for `query`, with a trace; extras.NeedTrace().
// Errors: INVALID_ARGUMENT for a log map around a vertex that allows none.
absl::StatusOr<std::shared_ptr<const DerivedQuantities>> Derive(
    const MeshHandle& mesh, const ValidQuery& query, const FieldHandle& field,
    const FieldExtras& extras, double radius, ByteReservation memory);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELDS_DERIVED_QUANTITIES_H_
