#include "server/engine/fields/matrix.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "absl/strings/str_cat.h"
#include "geodesic/field_path.h"
#include "server/engine/base/argument_checks.h"

namespace geodesic::server {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

absl::Status CheckMatrix(const MatrixRequest& request, const ValidQuery& query,
                         const Mesh& mesh, const Limits& limits) {
  absl::Status status = CheckRadius("radius", request.radius);
  if (!status.ok()) return status;
  const uint64_t rows = query->sources.size();
  const bool has_targets = !query->targets.empty();
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
      has_targets ? query->targets.size() : mesh.vertex_count();
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

RowFunction MakeRowFunction(MeshHandle mesh, ValidQuery query,
                            const MatrixRequest& request,
                            const SolveOptions& options, StartFunction start) {
  return [mesh = std::move(mesh), query = std::move(query),
          radius = request.radius, sparse = request.sparse,
          nearest = request.nearest, options, start = std::move(start)](
             uint64_t row, Checkpoint& checkpoint,
             ByteReservation memory) -> absl::StatusOr<MatrixRow> {
    const uint64_t targets = query->targets.size();
    MatrixRow result{.memory = std::move(memory)};
    auto computation =
        start(*mesh->mesh,
              query.OfSource(static_cast<uint32_t>(row), *mesh->mesh), options);
    if (!computation.ok()) return computation.status();
    Reach reach{.radius = radius};
    if (targets > 0) {
      reach.targets = std::min(nearest.value_or(targets), targets);
    }
    absl::Status status = (*computation)->Advance(reach, checkpoint);
    if (!status.ok()) return status;
    DistanceField field = (*computation)->Field();
    result.values = targets > 0 ? std::move(field.target_distances)
                                : std::move(field.distances);
    if (sparse || nearest.has_value()) {
      MakeSparse(radius, result);
      if (nearest.has_value()) KeepNearest(*nearest, result);
    } else if (!std::isinf(radius)) {
      for (double& value : result.values) {
        if (value > radius) value = kInfinity;
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
