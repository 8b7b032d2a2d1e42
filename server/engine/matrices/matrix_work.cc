#include "server/engine/matrices/matrix_work.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "geodesic/computation.h"
#include "geodesic/target_search.h"

namespace geodesic::server {

uint64_t MatrixWork::columns() const {
  return query->targets.empty() ? mesh->mesh->vertex_count()
                                : query->targets.size();
}

uint64_t MatrixWork::wanted() const {
  const uint64_t targets = query->targets.size();
  return std::min(filter.nearest.value_or(targets), targets);
}

uint64_t MatrixWork::PlannedBytes() const {
  return std::max(PlannedSolverBytes(*mesh->mesh, query),
                  SearchEngine::PlannedBytes(*mesh->mesh, query));
}

uint64_t MatrixWork::RowBytes() const {
  return (mesh->mesh->vertex_count() + query->targets.size()) *
         (sizeof(double) + sizeof(uint32_t) +
          (query->tolerance > 0 ? sizeof(float) : 0));
}

MatrixShape MatrixWork::Shape(size_t field_in_searches) const {
  return {.sources = rows(),
          .targets = columns(),
          .wanted = wanted(),
          .field_in_searches = field_in_searches};
}

std::optional<SearchMeans> MatrixWork::MeansFor(
    const ValidQuery& of_row) const {
  if (of_row->targets.empty() || !std::isinf(filter.radius) ||
      !TargetSearch::IsDirected(of_row->algorithm)) {
    return std::nullopt;
  }
  return searches.MeansFor(mesh, of_row->algorithm);
}

bool MatrixWork::TransposingPays() const {
  // Values of approximate methods are not the same from the other end.
  if (method.has_value() || query->targets.empty() || HasCurves(*query)) {
    return false;
  }
  if (!geodesic::TransposingPays(Shape(0))) return false;
  const auto means = MeansFor(query.OfSource(0, *mesh->mesh));
  return geodesic::TransposingPays(
      Shape(means.has_value() ? means->field_in_searches : 0));
}

absl::StatusOr<MatrixRow> MatrixWork::Answer(uint64_t row,
                                             Checkpoint& checkpoint,
                                             ByteReservation memory) const {
  MatrixRow result{.memory = std::move(memory)};
  absl::Status status =
      Compute(query.OfSource(static_cast<uint32_t>(row), *mesh->mesh),
              checkpoint, result);
  if (!status.ok()) return status;
  filter.Apply(result);
  return result;
}

absl::Status MatrixWork::Compute(const ValidQuery& of_row,
                                 Checkpoint& checkpoint,
                                 MatrixRow& result) const {
  if (method.has_value()) return Approximate(of_row, checkpoint, result);
  // Never without targets. Where searches do not pay with all landmarks, none
  // are wanted.
  if (SearchingPays(Shape(FieldInSearches(Landmarks::kMost)))) {
    const auto means = MeansFor(of_row);
    if (means.has_value() && SearchingPays(Shape(means->field_in_searches))) {
      return Search(of_row, *means, checkpoint, result);
    }
  }
  return Solve(of_row, checkpoint, result);
}

absl::Status MatrixWork::Approximate(const ValidQuery& of_row,
                                     Checkpoint& checkpoint,
                                     MatrixRow& result) const {
  absl::StatusOr<ApproximateField> field =
      method->method->Distances(of_row.DistancesAlone(), checkpoint);
  if (!field.ok()) return field.status();
  if (of_row->targets.empty()) {
    result.values = std::move(field->distances);
    return absl::OkStatus();
  }
  result.values.reserve(of_row->targets.size());
  for (const SurfacePoint& target : of_row->targets) {
    result.values.push_back(
        field->distances[std::get<VertexPoint>(target).vertex]);
  }
  return absl::OkStatus();
}

absl::Status MatrixWork::Search(const ValidQuery& of_row,
                                const SearchMeans& means,
                                Checkpoint& checkpoint,
                                MatrixRow& result) const {
  absl::StatusOr<TargetDistances> found =
      searches.Run(mesh, of_row, means, checkpoint);
  if (!found.ok()) return found.status();
  result.certified_error = found->certified_error;
  result.values = std::move(found->distances);
  return absl::OkStatus();
}

absl::Status MatrixWork::Solve(const ValidQuery& of_row, Checkpoint& checkpoint,
                               MatrixRow& result) const {
  auto computation = start(*mesh->mesh, of_row, options);
  if (!computation.ok()) return computation.status();
  const bool has_targets = !of_row->targets.empty();
  Reach reach{.radius = filter.radius};
  if (has_targets) reach.targets = wanted();
  absl::Status status = (*computation)->Advance(reach, checkpoint);
  if (!status.ok()) return status;
  DistanceField field = (*computation)->Field();
  result.certified_error = field.certified_error;
  result.values = has_targets ? std::move(field.target_distances)
                              : std::move(field.distances);
  return absl::OkStatus();
}

}  // namespace geodesic::server
