// Approximate methods, but for the heat method, whose CHOLMOD the package does
// not bring along.

#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <utility>

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

std::unique_ptr<MethodHandle> MakeMethod(const MeshHandle& mesh,
                                         const std::string& name,
                                         uint32_t neighbours, uint32_t samples,
                                         uint32_t threads,
                                         py::object progress) {
  Watch watch(std::move(progress));
  Prepared prepared = watch.Run([&] {
    return Prepare(*mesh.mesh, name, neighbours, samples, threads, watch);
  });
  return std::unique_ptr<MethodHandle>(
      new MethodHandle{mesh, std::move(prepared)});
}

// (distances, seconds) of the query's sources.
py::tuple DistancesOf(const MethodHandle& self, const QueryHandle& question,
                      py::object progress) {
  Watch watch(std::move(progress));
  ApproximateField field = watch.Run(
      [&] { return self.prepared->Distances(question.query, watch); });
  return py::make_tuple(ToArray(std::move(field.distances)),
                        field.solve_seconds);
}

}  // namespace

void BindMethods(py::module_& module) {
  py::class_<MethodHandle>(module, "Method")
      .def(py::init(&MakeMethod))
      .def("distances", &DistancesOf);
}

}  // namespace geodesic::python
