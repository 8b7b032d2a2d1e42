// Distances of pairs.

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "geodesic/rows/pairs.h"
#include "places.h"
#include "rows.h"
#include "subject.h"
#include "watch.h"

namespace geodesic::python {
namespace {

namespace py = pybind11;

// The distance from each of the sources to the target of the same number.
absl::StatusOr<std::vector<double>> FindDistances(const MeshHandle& on,
                                                  std::vector<PointPair> pairs,
                                                  PairOptions options,
                                                  uint32_t threads,
                                                  Watch& watch) {
  std::vector<double> distances(pairs.size());
  const auto question = PairQuestion::Make(
      *on.mesh, std::move(pairs), std::move(options), *on.searches, threads);
  if (!question.ok()) return question.status();
  const uint64_t rows = (*question)->rows().size();
  // The first row would make them with one thread.
  if (const uint32_t count = (*question)->landmarks(); count > 0) {
    RowsEnded before(0, rows, watch);
    absl::Status made =
        on.searches->MakeLandmarks(count, {.threads = threads}, before)
            .status();
    if (!made.ok()) return made;
  }
  absl::Status status =
      RunRows(rows, threads, watch, [&](uint64_t row, Checkpoint& checkpoint) {
        const absl::StatusOr<DistanceRow> found =
            (*question)->Answer(row, checkpoint);
        if (!found.ok()) return found.status();
        for (size_t i = 0; i < found->values.size(); ++i) {
          distances[found->columns[i]] = found->values[i];
        }
        return absl::OkStatus();
      });
  if (!status.ok()) return status;
  return distances;
}

py::array_t<double> Pairs(const MeshHandle& on, const PlaceArrays& sources,
                          const PlaceArrays& targets,
                          const MethodHandle* method, double tolerance,
                          uint32_t threads, py::object progress) {
  const std::vector<SurfacePoint> from = ToSurfacePoints(sources);
  const std::vector<SurfacePoint> to = ToSurfacePoints(targets);
  std::vector<PointPair> pairs;
  pairs.reserve(from.size());
  for (size_t i = 0; i < from.size(); ++i) pairs.push_back({from[i], to[i]});
  Watch watch(std::move(progress));
  return ToArray(watch.Run([&] {
    return FindDistances(
        on, std::move(pairs),
        {.tolerance = tolerance, .method = RowMethodOf(method)}, threads,
        watch);
  }));
}

}  // namespace

void BindPairs(py::module_& module) { module.def("pairs", &Pairs); }

}  // namespace geodesic::python
