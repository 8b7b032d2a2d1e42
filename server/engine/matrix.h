// Distances from each of many sources to the same targets.

#ifndef GEODESIC_SERVER_ENGINE_MATRIX_H_
#define GEODESIC_SERVER_ENGINE_MATRIX_H_

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/query.h"
#include "geodesic/solve_options.h"
#include "server/engine/clock.h"
#include "server/engine/field_engine.h"
#include "server/engine/limits.h"
#include "server/engine/mesh_store.h"
#include "server/engine/requester.h"
#include "server/engine/row_pipeline.h"
#include "server/engine/source_numbers.h"

namespace geodesic::server {

struct MatrixRequest {
  std::string mesh_digest;
  // Every source is a row, in the client's order. Without targets every vertex
  // is a column.
  Query query;
  SourceNumbers numbers;
  double radius = std::numeric_limits<double>::infinity();
  // Leave out what is infinite, and tell columns.
  bool sparse = false;
  // When set, each row has so many of its least values only, in their order,
  // and tells columns.
  std::optional<uint64_t> nearest;
  TimePoint deadline = kNoDeadline;
  Requester requester;
};

// Which of the query's sources each row is; see query.h for the numbers.
std::vector<uint32_t> RowSources(const MatrixRequest& request);

// Places against the mesh, and the size against the limits.
// Errors: INVALID_ARGUMENT, RESOURCE_EXHAUSTED.
absl::Status ValidateMatrix(const MatrixRequest& request, const Mesh& mesh,
                            const Limits& limits);

// A row is never larger than this while it is computed.
uint64_t RowBytes(const Query& query, const Mesh& mesh);

// What computes the rows of a valid request. They shrink their memory to what
// they keep. REQUIRES: they are given RowBytes.
RowFunction MakeRowFunction(MeshHandle mesh, MatrixRequest request,
                            const SolveOptions& options, StartFunction start);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MATRIX_H_
