#include "arrays.h"

#include <cstdint>
#include <limits>
#include <type_traits>

#include "absl/strings/str_cat.h"
#include "status.h"

namespace geodesic::python {
namespace {

namespace py = pybind11;

template <typename T>
std::vector<Triangle> TrianglesOf(const py::array& faces) {
  const auto rows =
      py::reinterpret_borrow<py::array_t<T>>(faces).template unchecked<2>();
  std::vector<Triangle> triangles(static_cast<size_t>(rows.shape(0)));
  for (py::ssize_t f = 0; f < rows.shape(0); ++f) {
    for (py::ssize_t corner = 0; corner < 3; ++corner) {
      const T vertex = rows(f, corner);
      if constexpr (std::is_signed_v<T> || sizeof(T) > sizeof(uint32_t)) {
        const bool fits =
            vertex >= 0 && static_cast<uint64_t>(vertex) <=
                               std::numeric_limits<uint32_t>::max();
        if (!fits) {
          Throw(absl::InvalidArgumentError(absl::StrCat(
              "faces[", f, ", ", corner, "] is ", vertex,
              ", which is out of range: vertices are numbered from 0, below "
              "2^32")));
        }
      }
      triangles[static_cast<size_t>(f)][static_cast<size_t>(corner)] =
          static_cast<uint32_t>(vertex);
    }
  }
  return triangles;
}

}  // namespace

std::vector<Triangle> ToTriangles(const py::array& faces) {
  if (py::isinstance<py::array_t<int32_t>>(faces)) {
    return TrianglesOf<int32_t>(faces);
  }
  if (py::isinstance<py::array_t<int64_t>>(faces)) {
    return TrianglesOf<int64_t>(faces);
  }
  if (py::isinstance<py::array_t<uint32_t>>(faces)) {
    return TrianglesOf<uint32_t>(faces);
  }
  if (py::isinstance<py::array_t<uint64_t>>(faces)) {
    return TrianglesOf<uint64_t>(faces);
  }
  throw py::type_error("faces must be 32- or 64-bit integers");
}

std::vector<Point> ToPoints(
    const py::array_t<double, py::array::c_style>& points) {
  static_assert(sizeof(Point) == 3 * sizeof(double));
  const auto* first = reinterpret_cast<const Point*>(points.data());
  return {first, first + points.shape(0)};
}

}  // namespace geodesic::python
