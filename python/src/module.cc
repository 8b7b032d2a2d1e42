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

// (name, parameter, its default) of each approximate method; None for both
// where it takes none.
py::list Methods() {
  const MethodChoice defaults;
  py::list methods;
  for (const ApproximateMethodInfo& info : kApproximateMethods) {
    py::object parameter = py::none();
    py::object value = py::none();
    if (info.parameter == MethodParameter::kLambda) {
      parameter = py::str("lambda_");
      value = py::float_(defaults.lambda);
    } else if (info.parameter == MethodParameter::kNeighbours) {
      parameter = py::str("neighbours");
      value = py::int_(defaults.neighbours);
    } else if (info.parameter == MethodParameter::kSamples) {
      parameter = py::str("samples");
      value = py::int_(defaults.samples);
    }
    methods.append(py::make_tuple(py::str(info.name.data()), parameter, value));
  }
  return methods;
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
  module.attr("METHODS") = py::tuple(Methods());
}

}  // namespace geodesic::python
