#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>

#include "geodesic/computation.h"
#include "geodesic/rows/matrix.h"
#include "geodesic/target_search.h"
#include "geodesic_types/field_path.h"
#include "rows/matrix_shape.h"

namespace geodesic {
namespace {

absl::Status CheckNearest(const RowFilter& filter, const Query& query) {
  if (!filter.nearest.has_value()) return absl::OkStatus();
  if (query.targets.empty()) {
    return InvalidField("targets", "targets is empty: name at least one");
  }
  if (*filter.nearest == 0) {
    return InvalidField("count", "count is 0; it must be at least 1");
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<MatrixQuestion> MatrixQuestion::Make(
    const Mesh& mesh, ValidQuery query, const RowFilter& filter,
    std::optional<RowMethod> method, RowMeans& means) {
  absl::Status status = CheckRadius(filter.radius);
  if (status.ok() && method.has_value()) {
    status = CheckPlaces(method->method, *query);
  }
  if (status.ok()) status = CheckNearest(filter, *query);
  if (!status.ok()) return status;
  return MatrixQuestion(mesh, std::move(query), filter, std::move(method),
                        means);
}

MatrixQuestion::MatrixQuestion(const Mesh& mesh, ValidQuery query,
                               const RowFilter& filter,
                               std::optional<RowMethod> method, RowMeans& means)
    : mesh_(&mesh),
      query_(std::move(query)),
      filter_(filter),
      method_(std::move(method)),
      means_(&means) {}

uint64_t MatrixQuestion::targets() const {
  return query_->targets.empty() ? mesh_->vertex_count()
                                 : query_->targets.size();
}

uint64_t MatrixQuestion::wanted() const {
  const uint64_t all = query_->targets.size();
  // The nearest are those of a row.
  return is_transposed_ ? all : std::min(filter_.nearest.value_or(all), all);
}

bool MatrixQuestion::MayBeSearched(const ValidQuery& of_line) const {
  return !of_line->targets.empty() && std::isinf(filter_.radius) &&
         TargetSearch::IsDirected(of_line->algorithm);
}

Algorithm MatrixQuestion::algorithm() const {
  return query_.OfSource(0, *mesh_)->algorithm;
}

bool MatrixQuestion::TransposingPays() const {
  // Values of approximate methods are not the same from the other end.
  if (method_.has_value() || query_->targets.empty() || HasCurves(*query_)) {
    return false;
  }
  MatrixShape shape{
      .sources = lines(), .targets = targets(), .wanted = wanted()};
  const ValidQuery first = query_.OfSource(0, *mesh_);
  if (MayBeSearched(first)) {
    shape.field_in_searches =
        FieldInSearches(first->algorithm, means_->landmarks().get());
  }
  return geodesic::TransposingPays(shape);
}

void MatrixQuestion::Transpose() {
  offsets_.reserve(lines());
  for (const Source& source : query_->sources) {
    offsets_.push_back(source.offset);
  }
  query_ = query_.Transposed(*mesh_);
  is_transposed_ = true;
}

uint64_t MatrixQuestion::PlannedBytes() const {
  return std::max(PlannedSolverBytes(*mesh_, query_),
                  TargetSearch::PlannedBytes(*mesh_, query_));
}

uint64_t MatrixQuestion::LineBytes() const {
  return (mesh_->vertex_count() + query_->targets.size()) *
         (sizeof(double) + sizeof(uint32_t) +
          (query_->tolerance > 0 ? sizeof(float) : 0));
}

absl::StatusOr<DistanceRow> MatrixQuestion::Answer(
    uint64_t line, Checkpoint& checkpoint) const {
  absl::StatusOr<DistanceRow> answer =
      Compute(query_.OfSource(static_cast<uint32_t>(line), *mesh_), checkpoint);
  if (!answer.ok()) return answer;
  if (is_transposed_) {
    for (size_t row = 0; row < offsets_.size(); ++row) {
      answer->values[row] += offsets_[row];
    }
    RowFilter{.radius = filter_.radius}.Apply(*answer);
  } else {
    filter_.Apply(*answer);
  }
  return answer;
}

absl::StatusOr<DistanceRow> MatrixQuestion::Compute(
    const ValidQuery& of_line, Checkpoint& checkpoint) const {
  if (method_.has_value()) return Approximate(of_line, checkpoint);
  if (MayBeSearched(of_line)) {
    const std::shared_ptr<const Landmarks> landmarks = means_->landmarks();
    if (SearchingPays({.sources = lines(),
                       .targets = targets(),
                       .wanted = wanted(),
                       .field_in_searches = FieldInSearches(
                           of_line->algorithm, landmarks.get())})) {
      absl::StatusOr<TargetDistances> found =
          means_->Search(of_line, landmarks.get(), checkpoint);
      if (!found.ok()) return found.status();
      return DistanceRow{.values = std::move(found->distances),
                         .certified_error = found->certified_error};
    }
  }
  return Solve(of_line, checkpoint);
}

absl::StatusOr<DistanceRow> MatrixQuestion::Approximate(
    const ValidQuery& of_line, Checkpoint& checkpoint) const {
  absl::StatusOr<ApproximateField> field =
      method_->prepared->Distances(of_line.DistancesAlone(), checkpoint);
  if (!field.ok()) return field.status();
  DistanceRow row;
  if (of_line->targets.empty()) {
    row.values = std::move(field->distances);
    return row;
  }
  row.values.reserve(of_line->targets.size());
  for (const SurfacePoint& target : of_line->targets) {
    row.values.push_back(
        field->distances[std::get<VertexPoint>(target).vertex]);
  }
  return row;
}

absl::StatusOr<DistanceRow> MatrixQuestion::Solve(
    const ValidQuery& of_line, Checkpoint& checkpoint) const {
  auto computation = means_->Start(of_line);
  if (!computation.ok()) return computation.status();
  const bool has_targets = !of_line->targets.empty();
  Reach reach{.radius = filter_.radius};
  if (has_targets) reach.targets = wanted();
  absl::Status status = (*computation)->Advance(reach, checkpoint);
  if (!status.ok()) return status;
  DistanceField field = (*computation)->Field();
  return DistanceRow{.values = std::move(has_targets ? field.target_distances
                                                     : field.distances),
                     .certified_error = field.certified_error};
}

}  // namespace geodesic
