// numpy arrays that take over what the core has made.

#ifndef GEODESIC_PYTHON_ARRAYS_H_
#define GEODESIC_PYTHON_ARRAYS_H_

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "geodesic/mesh.h"

namespace geodesic::python {

// The array owns the vector: its elements are not copied.
template <typename T>
pybind11::array_t<T> ToArray(std::vector<T> values) {
  auto* owned = new std::vector<T>(std::move(values));
  const pybind11::capsule owner(
      owned, [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return pybind11::array_t<T>(static_cast<pybind11::ssize_t>(owned->size()),
                              owned->data(), owner);
}

// The same for rows of N: an array of shape (size, N).
template <typename T, size_t N>
pybind11::array_t<T> ToArray(std::vector<std::array<T, N>> rows) {
  auto* owned = new std::vector<std::array<T, N>>(std::move(rows));
  const pybind11::capsule owner(owned, [](void* p) {
    delete static_cast<std::vector<std::array<T, N>>*>(p);
  });
  return pybind11::array_t<T>({static_cast<pybind11::ssize_t>(owned->size()),
                               static_cast<pybind11::ssize_t>(N)},
                              reinterpret_cast<const T*>(owned->data()), owner);
}

// An array that may only be read, of memory that `owner` keeps.
template <typename T>
pybind11::array_t<T> ViewOf(const T* data, std::vector<pybind11::ssize_t> shape,
                            pybind11::handle owner) {
  pybind11::array_t<T> view(std::move(shape), data, owner);
  view.attr("setflags")(pybind11::arg("write") = false);
  return view;
}

// Copies an array of shape (F, 3) of 32- or 64-bit integers.
// Throws: the package's InvalidArgument naming the first face with a number
// that no vertex can have.
std::vector<Triangle> ToTriangles(const pybind11::array& faces);

// Copies an array of shape (V, 3) of doubles in C order.
std::vector<Point> ToPoints(
    const pybind11::array_t<double, pybind11::array::c_style>& points);

}  // namespace geodesic::python

#endif  // GEODESIC_PYTHON_ARRAYS_H_
