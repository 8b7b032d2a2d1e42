// Meshes from the arrays of other libraries, and their results in place.
//
//   Eigen::MatrixXd V;  // V x 3: coordinates
//   Eigen::MatrixXi F;  // F x 3: vertices, counted from 0
//   absl::StatusOr<std::shared_ptr<const Mesh>> mesh = BuildMesh(V, F);
//
//   std::vector<double> xyz;   // 3 V coordinates
//   std::vector<int> corners;  // 3 F vertices
//   absl::StatusOr<std::shared_ptr<const Mesh>> same = BuildMesh(xyz, corners);
//
// Results are arrays already, without a copy: DistanceField::distances is a
// std::vector<double>, and Mesh::positions() are doubles, three a vertex:
//
//   Eigen::Map<const Eigen::VectorXd> d(field.distances.data(),
//                                       field.distances.size());

#ifndef GEODESIC_MESH_ARRAYS_H_
#define GEODESIC_MESH_ARRAYS_H_

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

#include "absl/status/statusor.h"
#include "geodesic/mesh.h"
#include "geodesic/triangle_soup.h"

namespace geodesic {

// Anything with rows(), cols() and (row, column): matrices of Eigen, whatever
// their order and scalars, and of others alike.
template <typename M>
concept MatrixLike = requires(const M& matrix) {
  { matrix.rows() } -> std::convertible_to<size_t>;
  { matrix.cols() } -> std::convertible_to<size_t>;
  { matrix(0, 0) } -> std::convertible_to<double>;
};

// What data() and size() describe, if it is no matrix: vectors, arrays, spans.
template <typename A>
concept FlatArray = !MatrixLike<A> && requires(const A& array) {
  std::span(std::data(array), std::size(array));
};

// The checks of BuildMesh, whatever the arrays' types.
namespace mesh_arrays {

// Errors: INVALID_ARGUMENT for a matrix without three columns.
absl::Status CheckColumns(const char* what, size_t columns);
// Errors: INVALID_ARGUMENT for a number of values that three does not divide.
absl::Status CheckLength(const char* what, size_t length);
// INVALID_ARGUMENT naming a corner that no vertex's number can be.
absl::Status BadCorner(size_t face, size_t corner, int64_t vertex);

// `coordinate(v, i)` and `corner(f, i)` say what the arrays hold.
template <typename Coordinate, typename Corner>
absl::StatusOr<std::shared_ptr<const Mesh>> Build(size_t vertices,
                                                  Coordinate coordinate,
                                                  size_t faces, Corner corner) {
  using Number = std::remove_cvref_t<decltype(corner(0, 0))>;
  static_assert(std::integral<Number>, "faces are numbers of vertices");
  TriangleSoup soup;
  soup.positions.resize(vertices);
  for (size_t v = 0; v < vertices; ++v) {
    for (size_t i = 0; i < 3; ++i) {
      soup.positions[v][i] = static_cast<double>(coordinate(v, i));
    }
  }
  soup.triangles.resize(faces);
  for (size_t f = 0; f < faces; ++f) {
    for (size_t i = 0; i < 3; ++i) {
      const Number vertex = corner(f, i);
      if (!std::in_range<uint32_t>(vertex)) {
        return BadCorner(f, i, static_cast<int64_t>(vertex));
      }
      soup.triangles[f][i] = static_cast<uint32_t>(vertex);
    }
  }
  return Mesh::Build(std::move(soup));
}

}  // namespace mesh_arrays

// The mesh of a V x 3 matrix of coordinates, in any unit, and an F x 3 matrix
// of vertex numbers. Copies both once. O(V + F log F) time.
// Errors: INVALID_ARGUMENT for a matrix without three columns, or a negative
// number; those of Mesh::Build.
template <MatrixLike Vertices, MatrixLike Faces>
absl::StatusOr<std::shared_ptr<const Mesh>> BuildMesh(const Vertices& vertices,
                                                      const Faces& faces) {
  for (const absl::Status& status :
       {mesh_arrays::CheckColumns("vertices", vertices.cols()),
        mesh_arrays::CheckColumns("faces", faces.cols())}) {
    if (!status.ok()) return status;
  }
  return mesh_arrays::Build(
      vertices.rows(),
      [&](size_t v, size_t i) {
        return vertices(static_cast<ptrdiff_t>(v), static_cast<ptrdiff_t>(i));
      },
      faces.rows(),
      [&](size_t f, size_t i) {
        return faces(static_cast<ptrdiff_t>(f), static_cast<ptrdiff_t>(i));
      });
}

// The same of flat arrays, row after row: 3 V coordinates, 3 F numbers.
// Errors: as above, and INVALID_ARGUMENT for lengths that three does not
// divide.
template <FlatArray Vertices, FlatArray Faces>
absl::StatusOr<std::shared_ptr<const Mesh>> BuildMesh(const Vertices& vertices,
                                                      const Faces& faces) {
  for (const absl::Status& status :
       {mesh_arrays::CheckLength("vertices", std::size(vertices)),
        mesh_arrays::CheckLength("faces", std::size(faces))}) {
    if (!status.ok()) return status;
  }
  const auto* xyz = std::data(vertices);
  const auto* corners = std::data(faces);
  return mesh_arrays::Build(
      std::size(vertices) / 3,
      [=](size_t v, size_t i) { return xyz[3 * v + i]; }, std::size(faces) / 3,
      [=](size_t f, size_t i) { return corners[3 * f + i]; });
}

}  // namespace geodesic

#endif  // GEODESIC_MESH_ARRAYS_H_
