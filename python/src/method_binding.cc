// Approximate methods, but for the heat method, whose CHOLMOD the package does
// not bring along.

#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "arrays.h"
#include "bindings.h"
#include "geodesic/approximate/fast_marching.h"
#include "geodesic/approximate/saddle_vertex_graph.h"
#include "geodesic/approximate/triangle_unfolding.h"
#include "geodesic_types/algorithms.h"
#include "status.h"
#include "subject.h"
#include "watch.h"

namespace geodesic::python {
namespace {

namespace py = pybind11;

using Prepared = std::shared_ptr<const PreparedMethod>;

// What was prepared of a mesh. Immutable.
struct Method {
  MeshHandle on;
  Prepared prepared;
};

absl::StatusOr<Prepared> Prepare(const Mesh& mesh, const std::string& name,
                                 uint32_t neighbours, uint32_t samples,
                                 uint32_t threads, Checkpoint& checkpoint) {
  const absl::StatusOr<ApproximateMethod> method =
      ApproximateMethodFromName(name);
  if (!method.ok()) return method.status();
  switch (*method) {
    case ApproximateMethod::kFmm:
      return FastMarching::Prepare(mesh, MarchingQueue::kHeap, checkpoint);
    case ApproximateMethod::kFmmUntidy:
      return FastMarching::Prepare(mesh, MarchingQueue::kUntidy, checkpoint);
    case ApproximateMethod::kSvg:
      return SaddleVertexGraph::Prepare(
          mesh, {.neighbours = neighbours, .threads = threads}, checkpoint);
    case ApproximateMethod::kGtu:
      return TriangleUnfolding::Prepare(
          mesh, {.samples = samples, .threads = threads}, checkpoint);
    default:
      return absl::InvalidArgumentError(absl::StrCat(
          "algorithm: ", name,
          " is not in this package, since it needs SuiteSparse; a service "
          "has it: geodesic.connect"));
  }
}

std::unique_ptr<Method> MakeMethod(const MeshHandle& mesh,
                                   const std::string& name, uint32_t neighbours,
                                   uint32_t samples, uint32_t threads,
                                   py::object progress) {
  Watch watch(std::move(progress));
  Prepared prepared = watch.Run([&] {
    return Prepare(*mesh.mesh, name, neighbours, samples, threads, watch);
  });
  return std::unique_ptr<Method>(new Method{mesh, std::move(prepared)});
}

// (distances, seconds) of the query's sources.
py::tuple DistancesOf(const Method& self, const QueryHandle& question,
                      py::object progress) {
  Watch watch(std::move(progress));
  ApproximateField field = watch.Run(
      [&] { return self.prepared->Distances(question.query, watch); });
  return py::make_tuple(ToArray(std::move(field.distances)),
                        field.solve_seconds);
}

// From each vertex of `sources` to that of `targets`, where the method finds
// pairs without fields; otherwise None. REQUIRES: vertices of the mesh.
py::object PairsOf(const Method& self, const py::array_t<uint32_t>& sources,
                   const py::array_t<uint32_t>& targets, py::object progress) {
  const auto* graph =
      dynamic_cast<const SaddleVertexGraph*>(self.prepared.get());
  const auto* unfolding =
      dynamic_cast<const TriangleUnfolding*>(self.prepared.get());
  if (graph == nullptr && unfolding == nullptr) return py::none();
  const auto from = sources.unchecked<1>();
  const auto to = targets.unchecked<1>();
  Watch watch(std::move(progress));
  std::vector<double> distances =
      watch.Run([&]() -> absl::StatusOr<std::vector<double>> {
        std::optional<SaddleGraphSearch> search;
        if (graph != nullptr) search.emplace(*graph);
        std::vector<double> found;
        const py::ssize_t count = from.shape(0);
        for (py::ssize_t i = 0; i < count; ++i) {
          found.push_back(search ? search->Distance(from(i), to(i), nullptr)
                                 : unfolding->Distance(from(i), to(i)));
          absl::Status status = watch.Report(static_cast<uint64_t>(i + 1),
                                             static_cast<uint64_t>(count));
          if (!status.ok()) return status;
        }
        return found;
      });
  return ToArray(std::move(distances));
}

}  // namespace

void BindMethods(py::module_& module) {
  py::class_<Method>(module, "Method")
      .def(py::init(&MakeMethod))
      .def("distances", &DistancesOf)
      .def("pairs", &PairsOf);
}

}  // namespace geodesic::python
