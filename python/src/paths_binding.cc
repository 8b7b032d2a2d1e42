#include <pybind11/stl.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "geodesic/path.h"
#include "geodesic/target_search.h"
#include "geodesic/trace.h"
#include "places.h"
#include "rows.h"
#include "solve_within.h"
#include "subject.h"
#include "watch.h"

namespace geodesic::python {
namespace {

namespace py = pybind11;
using PathList = std::vector<GeodesicPath>;

// To few targets by a search for each, otherwise from one field; then `watch`
// is told how many paths there are.
absl::StatusOr<PathList> FindPaths(const QueryHandle& question, double radius,
                                   uint32_t threads, Watch& watch) {
  const ValidQuery& query = question.query;
  const size_t targets = query->targets.size();
  const std::shared_ptr<const Landmarks> landmarks =
      question.on.searches->landmarks();
  if (TargetSearch::IsDirected(query->algorithm) && std::isinf(radius) &&
      targets < FieldInSearches(query->algorithm, landmarks.get())) {
    absl::StatusOr<TargetDistances> found =
        question.on.searches->Search(query, landmarks.get(), watch);
    if (!found.ok()) return found.status();
    return std::move(found->paths);
  }
  const absl::StatusOr<DistanceField> field =
      SolveWithin(question.mesh(), query,
                  {.radius = radius, .targets = targets}, threads, watch);
  if (!field.ok()) return field.status();
  const absl::StatusOr<PathTracer> tracer =
      PathTracer::Create(question.mesh(), query, *field);
  if (!tracer.ok()) return tracer.status();
  PathList paths;
  for (uint32_t target = 0; target < targets; ++target) {
    RowsEnded checkpoint(target, targets, watch);
    if (absl::Status status = checkpoint.Poll({}); !status.ok()) return status;
    absl::StatusOr<GeodesicPath> path = tracer->ToTarget(target, checkpoint);
    if (!path.ok()) return path.status();
    paths.push_back(*std::move(path));
  }
  return paths;
}

// (places, positions, distance, length, source) of each target's path.
py::list Paths(const QueryHandle& question, double radius, uint32_t threads,
               py::object progress) {
  Watch watch(std::move(progress));
  // As a service orders the sources, so that equally near ones are told alike.
  const SortedQuery sorted = question.query.Sorted();
  PathList paths = watch.Run([&] {
    return FindPaths({question.on, sorted.query}, radius, threads, watch);
  });
  py::list result;
  for (GeodesicPath& path : paths) {
    Watch::CheckSignals();
    result.append(py::make_tuple(
        ToPlaceArrays(path.points), ToArray(std::move(path.positions)),
        path.distance, path.length,
        std::isinf(path.distance) ? path.source : sorted.numbers[path.source]));
  }
  return result;
}

// Angles, of shape (lines,), or vectors, (lines, 3).
std::vector<LineDirection> ToDirections(const py::array_t<double>& array) {
  std::vector<LineDirection> directions;
  if (array.ndim() == 1) {
    const auto angle = array.unchecked<1>();
    for (py::ssize_t i = 0; i < angle.shape(0); ++i) {
      directions.emplace_back(angle(i));
    }
    return directions;
  }
  const auto vector = array.unchecked<2>();
  for (py::ssize_t i = 0; i < vector.shape(0); ++i) {
    directions.emplace_back(Point{vector(i, 0), vector(i, 1), vector(i, 2)});
  }
  return directions;
}

// (places, positions, length, name of the end) of each line. Of sources,
// directions and lengths there is one for all, or one for each.
py::list Trace(const MeshHandle& on, const PlaceArrays& sources,
               const py::array_t<double>& directions,
               std::vector<double> lengths, uint32_t threads,
               py::object progress) {
  const LineQuestion question{.sources = ToSurfacePoints(sources),
                              .directions = ToDirections(directions),
                              .lengths = std::move(lengths)};
  Watch watch(std::move(progress));
  std::vector<TracedLine> lines =
      watch.Run([&]() -> absl::StatusOr<std::vector<TracedLine>> {
        const absl::StatusOr<uint64_t> count = CountLines(question);
        if (!count.ok()) return count.status();
        std::vector<TracedLine> traced(*count);
        absl::Status status = RunRows(
            *count, threads, watch, [&](uint64_t line, Checkpoint& checkpoint) {
              return TraceLines(*on.mesh, question, line, line + 1, checkpoint,
                                [&](TracedLine found) {
                                  traced[line] = std::move(found);
                                  return absl::OkStatus();
                                });
            });
        if (!status.ok()) return status;
        return traced;
      });
  py::list result;
  for (TracedLine& line : lines) {
    Watch::CheckSignals();
    result.append(py::make_tuple(
        ToPlaceArrays(line.points), ToArray(std::move(line.positions)),
        line.length, std::string(TraceEndName(line.end))));
  }
  return result;
}

}  // namespace

void BindPaths(py::module_& module) {
  module.def("paths", &Paths);
  module.def("trace", &Trace);
}

}  // namespace geodesic::python
