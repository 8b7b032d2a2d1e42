#include "status.h"

#include <pybind11/pybind11.h>

#include <string>

namespace geodesic::python {

namespace py = pybind11;

void Throw(const absl::Status& status) {
  const py::object error =
      py::module_::import("geodesic.errors")
          .attr("from_code")(static_cast<int>(status.code()),
                             std::string(status.message()));
  PyErr_SetObject(py::type::handle_of(error).ptr(), error.ptr());
  throw py::error_already_set();
}

}  // namespace geodesic::python
