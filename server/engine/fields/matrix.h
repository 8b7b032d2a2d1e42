// Distances from each of many sources to the same targets.

#ifndef GEODESIC_SERVER_ENGINE_FIELDS_MATRIX_H_
#define GEODESIC_SERVER_ENGINE_FIELDS_MATRIX_H_

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/query.h"
#include "geodesic/solve_options.h"
#include "geodesic/valid_query.h"
#include "server/engine/base/clock.h"
#include "server/engine/base/limits.h"
#include "server/engine/fields/field_engine.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/meshes/mesh_store.h"

namespace geodesic::server {

struct MatrixRequest {
  std::string mesh_digest;
  // Every source is a row, in their order. Without targets every vertex
  // is a column.
  Query query;
  double radius = std::numeric_limits<double>::infinity();
  // Leave out what is infinite, and tell columns.
  bool sparse = false;
  // When set, each row has so many of its least values only, in their order,
  // and tells columns.
  std::optional<uint64_t> nearest;
  TimePoint deadline = kNoDeadline;
  Requester requester;
};

// Checks all but the query, which has become `query`: the size against the
// limits, too. Errors: INVALID_ARGUMENT, RESOURCE_EXHAUSTED.
absl::Status CheckMatrix(const MatrixRequest& request, const ValidQuery& query,
                         const Mesh& mesh, const Limits& limits);

// A row is never larger than this while it is computed.
uint64_t RowBytes(const Query& query, const Mesh& mesh);

// What computes the rows of a checked request. They shrink their memory to what
// they keep. REQUIRES: they are given RowBytes.
RowFunction MakeRowFunction(MeshHandle mesh, ValidQuery query,
                            const MatrixRequest& request,
                            const SolveOptions& options, StartFunction start);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELDS_MATRIX_H_
