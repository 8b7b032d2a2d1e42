#include <pybind11/stl.h>

#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "geodesic/isolines.h"
#include "geodesic/sampling.h"
#include "places.h"
#include "subject.h"
#include "watch.h"

namespace geodesic::python {
namespace {

namespace py = pybind11;

// (level, is_closed, places, positions) of each.
py::list Isolines(const QueryHandle& question, std::vector<double> levels,
                  double chord_error, uint32_t threads, py::object progress) {
  Watch watch(std::move(progress));
  std::vector<Isoline> isolines = watch.Run([&] {
    return ComputeIsolines(question.mesh(), question.query,
                           {std::move(levels), chord_error},
                           {.threads = threads}, watch);
  });
  py::list result;
  for (Isoline& isoline : isolines) {
    result.append(py::make_tuple(isoline.level, isoline.is_closed,
                                 ToPlaceArrays(isoline.points),
                                 ToArray(std::move(isoline.positions))));
  }
  return result;
}

// (vertices, distances).
py::tuple Samples(const QueryHandle& question, uint32_t count, uint32_t threads,
                  py::object progress) {
  Watch watch(std::move(progress));
  const std::vector<FarthestSample> samples = watch.Run([&] {
    return SampleFarthestPoints(question.mesh(), question.query, count,
                                {.threads = threads}, watch);
  });
  std::vector<int64_t> vertices;
  std::vector<double> distances;
  for (const FarthestSample& sample : samples) {
    vertices.push_back(sample.vertex);
    distances.push_back(sample.distance);
  }
  return py::make_tuple(ToArray(std::move(vertices)),
                        ToArray(std::move(distances)));
}

}  // namespace

void BindQuestions(py::module_& module) {
  module.def("isolines", &Isolines);
  module.def("samples", &Samples);
}

}  // namespace geodesic::python
