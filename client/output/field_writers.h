// Writes values at the vertices in the formats that other programs read.
//
// Bytes are little endian unless said otherwise. +infinity stays infinity in
// every format. A writer appends to the file, whose Commit returns errors. A
// `mark` (approximation_mark.h) is written as the format's comment; .csv has
// none, but names of columns.

#ifndef GEODESIC_CLIENT_OUTPUT_FIELD_WRITERS_H_
#define GEODESIC_CLIENT_OUTPUT_FIELD_WRITERS_H_

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "client/output/atomic_file.h"
#include "client/output/binary_numbers.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

// The names of columns, in every format that has names.
inline constexpr char kDistanceColumn[] = "geodesic_distance";
inline constexpr char kNearestSourceColumn[] = "nearest_source";
inline constexpr char kGradientColumn[] = "gradient";
inline constexpr char kErrorColumn[] = "certified_error";

// In the header of .ply.
inline constexpr char kUnitComment[] =
    "comment distances in the unit of the coordinates";

struct Column {
  std::string name;
  // `components` values for each vertex, vertex by vertex.
  std::vector<double> values;
  size_t components = 1;  // or 3, a vector
  NumberType type = NumberType::kFloat64;

  bool is_integer() const { return IsInteger(type); }
  // "gradient_x", "gradient_y" and "gradient_z", or the name as it is.
  std::vector<std::string> names() const {
    if (components == 1) return {name};
    return {name + "_x", name + "_y", name + "_z"};
  }
  // The type of its values in .ply and .vtk, and what these call it.
  NumberType stored_type() const {
    return is_integer() ? NumberType::kInt32 : type;
  }
  std::string_view stored_name() const { return PlyName(stored_type()); }
  size_t count() const { return values.size() / components; }
  // NumPy's shape: (count), or (count, components).
  std::vector<uint64_t> shape() const {
    if (components == 1) return {count()};
    return {count(), components};
  }
};

// NumPy format 1.0: shape (V,), or (V, components).
void WriteNpy(const Column& column, AtomicFile* file,
              const std::string& mark = "");

// A header line "vertex,geodesic_distance,...", then a line for each vertex. A
// vector is three columns: gradient_x, gradient_y, gradient_z.
void WriteCsv(std::span<const Column> columns, AtomicFile* file);

// Binary PLY. Vertices have x, y, z as double and the columns, each as double,
// float or int, with vectors as in .csv. Then come the faces.
// REQUIRES: a value per vertex; fewer than 2^31 vertices. Likewise for
// WriteVtk.
void WritePly(const MeshArrays& mesh, std::span<const Column> columns,
              AtomicFile* file, const std::string& mark = "");

// Legacy VTK polydata with the columns as point scalars and vectors, of these
// types too. It is
// binary, which in that format means big endian.
void WriteVtk(const MeshArrays& mesh, std::span<const Column> columns,
              AtomicFile* file, const std::string& mark = "");

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_FIELD_WRITERS_H_
