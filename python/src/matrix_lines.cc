#include "matrix_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geodesic/target_search.h"
#include "rows.h"
#include "solve_within.h"

namespace geodesic::python {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

MatrixLines::MatrixLines(QueryHandle question, double radius, uint64_t wanted)
    : question_(std::move(question)), radius_(radius), wanted_(wanted) {
  const ValidQuery& query = question_.query;
  if (query->targets.empty() || HasCurves(*query)) return;
  const Mesh& mesh = question_.mesh();
  if (TransposingPays(
          ShapeOf(query.OfSource(0, mesh), query->sources.size(), wanted_))) {
    transposed_ = query.Transposed(mesh);
  }
}

MatrixShape MatrixLines::ShapeOf(const ValidQuery& of_line, uint64_t sources,
                                 uint64_t wanted) const {
  const uint64_t targets = of_line->targets.size();
  const bool may_search =
      std::isinf(radius_) && TargetSearch::IsDirected(of_line->algorithm);
  return {.sources = sources,
          .targets = targets,
          .wanted = std::min(wanted, targets),
          .field_in_searches =
              may_search ? question_.on.searches->FieldInSearches() : 0};
}

absl::StatusOr<std::vector<double>> MatrixLines::LineOf(
    const ValidQuery& of_line, uint64_t wanted, Checkpoint& checkpoint) const {
  const MatrixShape shape = ShapeOf(of_line, 1, wanted);
  if (shape.targets > 0 && SearchingPays(shape)) {
    absl::StatusOr<TargetDistances> found =
        question_.on.searches->Run(of_line, checkpoint);
    if (!found.ok()) return found.status();
    return std::move(found->distances);
  }
  Reach reach{.radius = radius_};
  if (shape.targets > 0) reach.targets = shape.wanted;
  absl::StatusOr<DistanceField> field =
      SolveWithin(question_.mesh(), of_line, reach, /*threads=*/1, checkpoint);
  if (!field.ok()) return field.status();
  return std::move(shape.targets > 0 ? field->target_distances
                                     : field->distances);
}

absl::Status MatrixLines::ComputeSources(const ValidQuery& query,
                                         uint64_t wanted, uint32_t threads,
                                         Watch& watch, const Put& put) const {
  return RunRows(
      query->sources.size(), threads, watch,
      [&](uint64_t row, Checkpoint& checkpoint) -> absl::Status {
        absl::StatusOr<std::vector<double>> values =
            LineOf(query.OfSource(static_cast<uint32_t>(row), question_.mesh()),
                   wanted, checkpoint);
        if (!values.ok()) return values.status();
        put(row, *values);
        return absl::OkStatus();
      });
}

absl::Status MatrixLines::Compute(uint32_t threads, Watch& watch,
                                  const Put& put) const {
  if (!transposed_.has_value()) {
    return ComputeSources(question_.query, wanted_, threads, watch, put);
  }
  const std::vector<Source>& sources = question_.query->sources;
  return ComputeSources(*transposed_, sources.size(), threads, watch,
                        [&](uint64_t column, std::span<double> values) {
                          for (size_t row = 0; row < values.size(); ++row) {
                            values[row] += sources[row].offset;
                            if (values[row] > radius_) values[row] = kInfinity;
                          }
                          put(column, values);
                        });
}

absl::Status MatrixLines::ComputeRows(uint32_t threads, Watch& watch,
                                      const Put& put) const {
  if (!transposed_.has_value()) return Compute(threads, watch, put);
  const size_t columns = question_.query->targets.size();
  std::vector<double> table(question_.query->sources.size() * columns);
  absl::Status status = Compute(
      threads, watch, [&](uint64_t column, std::span<const double> values) {
        for (size_t row = 0; row < values.size(); ++row) {
          table[row * columns + column] = values[row];
        }
      });
  if (!status.ok()) return status;
  for (size_t row = 0; row * columns < table.size(); ++row) {
    put(row, {table.data() + row * columns, columns});
  }
  return absl::OkStatus();
}

}  // namespace geodesic::python
