#include "server/engine/matrix.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/engine/argument_checks.h"
#include "server/engine/status_details.h"

namespace geodesic::server {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The question of one row.
Query RowQuery(const Query& all, uint32_t source) {
  Query query{.targets = all.targets, .algorithm = all.algorithm};
  if (source < all.sources.size()) {
    query.sources = {all.sources[source]};
  } else {
    query.curves = {all.curves[source - all.sources.size()]};
  }
  return query;
}

// Keeps what lies within the radius, with its columns.
void MakeSparse(double radius, MatrixRow& row) {
  size_t kept = 0;
  for (size_t column = 0; column < row.values.size(); ++column) {
    const double value = row.values[column];
    if (value > radius || value == kInfinity) continue;
    row.columns.push_back(static_cast<uint32_t>(column));
    row.values[kept++] = value;
  }
  row.values.resize(kept);
}

// Keeps the `count` least values of a sparse row, in order.
void KeepNearest(uint64_t count, MatrixRow& row) {
  std::vector<uint32_t> order(row.values.size());
  std::iota(order.begin(), order.end(), 0);
  const size_t kept = std::min<uint64_t>(count, order.size());
  std::ranges::partial_sort(
      order, order.begin() + static_cast<std::ptrdiff_t>(kept), {},
      [&](uint32_t i) { return std::pair(row.values[i], row.columns[i]); });
  order.resize(kept);
  std::vector<uint32_t> columns;
  std::vector<double> values;
  for (const uint32_t i : order) {
    columns.push_back(row.columns[i]);
    values.push_back(row.values[i]);
  }
  row.columns = std::move(columns);
  row.values = std::move(values);
}

}  // namespace

std::vector<uint32_t> RowSources(const MatrixRequest& request) {
  std::vector<uint32_t> sources(SourceCount(request.query));
  const SourceNumbers& numbers = request.numbers;
  if (numbers.points.empty() && numbers.curves.empty()) {
    std::iota(sources.begin(), sources.end(), 0);
    return sources;
  }
  uint32_t source = 0;
  for (const uint32_t row : numbers.points) sources[row] = source++;
  for (const uint32_t row : numbers.curves) sources[row] = source++;
  return sources;
}

absl::Status ValidateMatrix(const MatrixRequest& request, const Mesh& mesh,
                            const Limits& limits) {
  absl::Status status =
      ValidateAsNumbered(request.query, request.numbers, mesh);
  if (!status.ok()) return status;
  status = CheckRadius("max_distance", request.radius);
  if (!status.ok()) return status;
  const uint64_t rows = SourceCount(request.query);
  const bool has_targets = !request.query.targets.empty();
  if (request.nearest.has_value()) {
    if (!has_targets) {
      return InvalidField("targets", "targets is empty: name at least one");
    }
    if (*request.nearest == 0) {
      return InvalidField("count", "count is 0; it must be at least 1");
    }
    return absl::OkStatus();
  }
  const uint64_t columns =
      has_targets ? request.query.targets.size() : mesh.vertex_count();
  if (columns > limits.max_matrix_values / rows) {
    return absl::ResourceExhaustedError(absl::StrCat(
        "the matrix has ", rows, " rows of ", columns,
        " values; max_matrix_values is ", limits.max_matrix_values));
  }
  return absl::OkStatus();
}

uint64_t RowBytes(const Query& query, const Mesh& mesh) {
  return (mesh.vertex_count() + query.targets.size()) *
         (sizeof(double) + sizeof(uint32_t));
}

RowFunction MakeRowFunction(MeshHandle mesh, MatrixRequest request,
                            const SolveOptions& options, StartFunction start) {
  std::vector<uint32_t> sources = RowSources(request);
  return [mesh = std::move(mesh), request = std::move(request), options,
          start = std::move(start), sources = std::move(sources)](
             uint64_t row, Checkpoint& checkpoint,
             ByteReservation memory) -> absl::StatusOr<MatrixRow> {
    const Query& all = request.query;
    const bool has_targets = !all.targets.empty();
    MatrixRow result{.memory = std::move(memory)};
    auto computation = start(*mesh->mesh, RowQuery(all, sources[row]), options);
    if (!computation.ok()) return computation.status();
    Reach reach{.radius = request.radius};
    if (has_targets) {
      reach.targets = std::min<uint64_t>(
          request.nearest.value_or(all.targets.size()), all.targets.size());
    }
    absl::Status status = (*computation)->Advance(reach, checkpoint);
    if (!status.ok()) return status;
    DistanceField field = (*computation)->Field();
    result.values = has_targets ? std::move(field.target_distances)
                                : std::move(field.distances);
    if (request.sparse || request.nearest.has_value()) {
      MakeSparse(request.radius, result);
      if (request.nearest.has_value()) KeepNearest(*request.nearest, result);
    } else if (!std::isinf(request.radius)) {
      for (double& value : result.values) {
        if (value > request.radius) value = kInfinity;
      }
    }
    result.columns.shrink_to_fit();
    result.values.shrink_to_fit();
    result.memory.ShrinkTo(result.values.size() * sizeof(double) +
                           result.columns.size() * sizeof(uint32_t));
    return result;
  };
}

}  // namespace geodesic::server
