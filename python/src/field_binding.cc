#include <pybind11/stl.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "geodesic/computation.h"
#include "geodesic/field_quantities.h"
#include "geodesic/log_map.h"
#include "geodesic/settled_vertices.h"
#include "solve_within.h"
#include "status.h"
#include "subject.h"
#include "watch.h"

namespace geodesic::python {
namespace {

namespace py = pybind11;

// A field and what it was asked of, with its sources in the order in which a
// service takes them: where sources are equally near, both say the same one.
// Immutable but for TakeDistances.
struct Field {
  QueryHandle question;
  std::vector<uint32_t> numbers;  // of the sources, as the caller has them
  DistanceField field;
};

std::unique_ptr<Field> Solve(const QueryHandle& question, double radius,
                             uint64_t stop_after_targets, uint32_t threads,
                             py::object progress) {
  Watch watch(std::move(progress));
  SortedQuery sorted = question.query.Sorted();
  DistanceField field = watch.Run([&] {
    return SolveWithin(question.mesh(), sorted.query,
                       {.radius = radius, .targets = stop_after_targets},
                       threads, watch);
  });
  return std::unique_ptr<Field>(
      new Field{{question.on, std::move(sorted.query)},
                std::move(sorted.numbers),
                std::move(field)});
}

py::array_t<double> Distances(const py::object& self) {
  const DistanceField& field = self.cast<const Field&>().field;
  return ViewOf(field.distances.data(),
                {static_cast<py::ssize_t>(field.distances.size())}, self);
}

py::dict Statistics(const Field& self) {
  const SolveStatistics& statistics = self.field.statistics;
  using namespace py::literals;
  return py::dict("iterations"_a = statistics.iterations,
                  "windows_created"_a = statistics.windows_created,
                  "windows_propagated"_a = statistics.windows_propagated,
                  "peak_wavefront"_a = statistics.peak_wavefront,
                  "mean_wavefront"_a = statistics.mean_wavefront,
                  "peak_windows"_a = statistics.peak_windows,
                  "peak_solver_bytes"_a = statistics.peak_solver_bytes,
                  "solve_seconds"_a = statistics.solve_seconds);
}

py::array_t<uint32_t> NearestSourcesOf(const Field& self) {
  Watch watch{py::none()};
  std::vector<uint32_t> labels = watch.Run([&] {
    return NearestSources(self.question.mesh(), self.question.query, self.field,
                          watch);
  });
  for (uint32_t& label : labels) {
    if (label != kNoSource) label = self.numbers[label];
  }
  return ToArray(std::move(labels));
}

py::array_t<double> GradientsOf(const Field& self) {
  Watch watch{py::none()};
  return ToArray(watch.Run([&] {
    return Gradients(self.question.mesh(), self.question.query, self.field,
                     watch);
  }));
}

// 0 everywhere if the field is exact.
py::array_t<float> CertifiedErrorsOf(const Field& self) {
  std::vector<float> errors = self.field.certified_errors;
  errors.resize(self.question.mesh().vertex_count());
  return ToArray(std::move(errors));
}

py::tuple LogMapOf(const Field& self, double radius) {
  Watch watch{py::none()};
  LogMap map = watch.Run([&] {
    return ComputeLogMap(self.question.mesh(), self.question.query, self.field,
                         radius, watch);
  });
  return py::make_tuple(ToArray(std::move(map.coordinates)),
                        map.zero_direction);
}

// A computation whose vertices are handed out as they become final. For one
// thread at a time.
class Progression {
 public:
  Progression(QueryHandle question, double radius, uint32_t threads)
      : question_(std::move(question)),
        radius_(radius),
        computation_(ValueOrThrow(StartComputation(
            question_.mesh(), question_.query, {.threads = threads}))),
        settled_(question_.mesh()) {}

  // (vertices, distances) of those that have become final since the last call,
  // in order of distance; waits until there are some, and about `seconds`. None
  // at the end.
  py::object Next(double seconds) {
    if (is_over_) return py::none();
    Watch watch{py::none()};
    Slice slice(settled_, watch, seconds);
    std::vector<SettledVertex> found =
        watch.Run([&]() -> absl::StatusOr<std::vector<SettledVertex>> {
          const absl::Status status =
              computation_->Advance({.radius = radius_}, slice);
          if (slice.is_full()) return slice.found();
          if (!status.ok()) return status;
          is_over_ = true;
          const DistanceField field = computation_->Field();
          return settled_.Collect({.settled_radius = field.settled_radius,
                                   .distances = field.distances});
        });
    std::vector<int64_t> vertices;
    std::vector<double> distances;
    for (const SettledVertex& settled : found) {
      if (settled.distance > radius_) continue;
      vertices.push_back(settled.vertex);
      distances.push_back(settled.distance);
    }
    return py::make_tuple(ToArray(std::move(vertices)),
                          ToArray(std::move(distances)));
  }

 private:
  // Stops a computation when its time is over and vertices have become final.
  class Slice final : public Checkpoint {
   public:
    Slice(SettledVertices& settled, Watch& watch, double seconds)
        : settled_(settled),
          watch_(watch),
          end_(std::chrono::steady_clock::now() +
               std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                   std::chrono::duration<double>(seconds))) {}

    absl::Status Poll(const Progress& progress) override {
      if (absl::Status status = watch_.Poll(progress); !status.ok()) {
        return status;
      }
      if (std::chrono::steady_clock::now() < end_) return absl::OkStatus();
      found_ = settled_.Collect(progress);
      if (found_.empty()) return absl::OkStatus();
      return absl::CancelledError("the slice is full");
    }

    bool is_full() const { return !found_.empty(); }
    const std::vector<SettledVertex>& found() const { return found_; }

   private:
    SettledVertices& settled_;
    Watch& watch_;
    const std::chrono::steady_clock::time_point end_;
    std::vector<SettledVertex> found_;
  };

  const QueryHandle question_;
  const double radius_;
  std::unique_ptr<Computation> computation_;
  SettledVertices settled_;
  bool is_over_ = false;
};

}  // namespace

void BindField(py::module_& module) {
  py::class_<Field>(module, "Field")
      .def_property_readonly("distances", &Distances)
      .def("take_distances",
           [](Field& self) { return ToArray(std::move(self.field.distances)); })
      .def("take_target_distances",
           [](Field& self) {
             return ToArray(std::move(self.field.target_distances));
           })
      .def_property_readonly(
          "settled_radius",
          [](const Field& self) { return self.field.settled_radius; })
      .def_property_readonly(
          "algorithm",
          [](const Field& self) {
            return py::str(AlgorithmName(self.field.algorithm).data());
          })
      .def("statistics", &Statistics)
      .def("nearest_sources", &NearestSourcesOf)
      .def("gradients", &GradientsOf)
      .def_property_readonly(
          "certified_error",
          [](const Field& self) { return self.field.certified_error; })
      .def("certified_errors", &CertifiedErrorsOf)
      .def("log_map", &LogMapOf);
  module.def("solve", &Solve);
  py::class_<Progression>(module, "Progression")
      .def(py::init<QueryHandle, double, uint32_t>())
      .def("next", &Progression::Next);
}

}  // namespace geodesic::python
