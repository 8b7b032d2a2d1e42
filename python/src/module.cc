// The extension module `geodesic._core`: the core, for geodesic/local.py.

#include "bindings.h"
#include "geodesic_types/algorithms.h"

namespace geodesic::python {
namespace {

namespace py = pybind11;

// (name, summary) of each; the first is the default.
py::list Algorithms() {
  py::list algorithms;
  for (const AlgorithmInfo& info : kAlgorithms) {
    algorithms.append(py::make_tuple(py::str(info.name.data()),
                                     py::str(info.summary.data())));
  }
  return algorithms;
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  py::options options;
  options.disable_function_signatures();
  BindMesh(module);
  BindField(module);
  BindMethods(module);
  BindPaths(module);
  BindQuestions(module);
  BindPairs(module);
  BindRows(module);
  module.attr("VERSION") = GEODESIC_VERSION;
  module.attr("ALGORITHMS") = py::tuple(Algorithms());
}

}  // namespace geodesic::python
