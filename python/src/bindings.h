// The parts of the module `geodesic._core`, a file each. Docstrings are in
// geodesic/_core.pyi; users see geodesic.Mesh instead.

#ifndef GEODESIC_PYTHON_BINDINGS_H_
#define GEODESIC_PYTHON_BINDINGS_H_

#include <pybind11/pybind11.h>

namespace geodesic::python {

void BindMesh(pybind11::module_& module);     // Mesh, Query, polygons
void BindField(pybind11::module_& module);    // Computation, Field
void BindMethods(pybind11::module_& module);  // approximate ones
void BindPaths(pybind11::module_& module);
void BindQuestions(pybind11::module_& module);  // isolines, samples
void BindPairs(pybind11::module_& module);
void BindRows(pybind11::module_& module);  // matrices, nearest

}  // namespace geodesic::python

#endif  // GEODESIC_PYTHON_BINDINGS_H_
