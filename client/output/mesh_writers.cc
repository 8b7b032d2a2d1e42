// The formats that hold the mesh and values on it: .ply, .vtk.

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

#include "absl/strings/str_cat.h"
#include "client/output/big_endian.h"
#include "client/output/field_writers.h"

namespace geodesic::client {
namespace {

// Appends a value of a column to a row of a PLY file.
void AppendToRow(double value, bool is_integer, std::string* row) {
  AppendNumbers({&value, 1},
                is_integer ? NumberType::kInt32 : NumberType::kFloat64, row);
}

void WriteVtkColumn(const Column& column, AtomicFile* file) {
  const char* type = column.is_integer() ? "int" : "double";
  if (column.components == 1) {
    file->Append(absl::StrCat("\nSCALARS ", column.name, " ", type,
                              " 1\nLOOKUP_TABLE default\n"));
  } else {
    file->Append(absl::StrCat("\nVECTORS ", column.name, " ", type, "\n"));
  }
  for (const double value : column.values) {
    if (column.is_integer()) {
      const uint32_t swapped =
          BigEndian(static_cast<uint32_t>(static_cast<int32_t>(value)));
      file->Append(&swapped, sizeof(swapped));
    } else {
      const uint64_t swapped = BigEndian(value);
      file->Append(&swapped, sizeof(swapped));
    }
  }
}

}  // namespace

void WritePly(const MeshArrays& mesh, std::span<const Column> columns,
              AtomicFile* file) {
  std::string header = absl::StrCat(
      "ply\nformat binary_little_endian 1.0\n"
      "comment distances in the unit of the coordinates\n"
      "element vertex ",
      mesh.positions.size(),
      "\nproperty double x\nproperty double y\nproperty double z\n");
  for (const Column& column : columns) {
    const std::string property = absl::StrCat(
        "property ", column.is_integer() ? "int " : "double ", column.name);
    if (column.components == 1) {
      absl::StrAppend(&header, property, "\n");
    } else {
      for (const char* axis : {"_x\n", "_y\n", "_z\n"}) {
        absl::StrAppend(&header, property, axis);
      }
    }
  }
  if (!mesh.triangles.empty()) {
    absl::StrAppend(&header, "element face ", mesh.triangles.size(),
                    "\nproperty list uchar int vertex_indices\n");
  }
  file->Append(header + "end_header\n");
  std::string row;
  for (size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    row.clear();
    AppendNumbers(mesh.positions[vertex], NumberType::kFloat64, &row);
    for (const Column& column : columns) {
      for (size_t i = 0; i < column.components; ++i) {
        AppendToRow(column.values[vertex * column.components + i],
                    column.is_integer(), &row);
      }
    }
    file->Append(row);
  }
  for (const Triangle& triangle : mesh.triangles) {
    std::array<char, 1 + sizeof(Triangle)> face = {3};
    std::memcpy(face.data() + 1, triangle.data(), sizeof(Triangle));
    file->Append(face.data(), face.size());
  }
}

void WriteVtk(const MeshArrays& mesh, std::span<const Column> columns,
              AtomicFile* file) {
  file->Append(
      absl::StrCat("# vtk DataFile Version 3.0\ngeodesic distance field\n"
                   "BINARY\nDATASET POLYDATA\nPOINTS ",
                   mesh.positions.size(), " double\n"));
  for (const Point& point : mesh.positions) {
    const std::array<uint64_t, 3> row = {
        BigEndian(point[0]), BigEndian(point[1]), BigEndian(point[2])};
    file->Append(row.data(), sizeof(row));
  }
  file->Append(absl::StrCat("\nPOLYGONS ", mesh.triangles.size(), " ",
                            4 * mesh.triangles.size(), "\n"));
  for (const Triangle& triangle : mesh.triangles) {
    const std::array<uint32_t, 4> row = {
        BigEndian(uint32_t{3}), BigEndian(triangle[0]), BigEndian(triangle[1]),
        BigEndian(triangle[2])};
    file->Append(row.data(), sizeof(row));
  }
  file->Append(absl::StrCat("\nPOINT_DATA ", mesh.positions.size()));
  for (const Column& column : columns) WriteVtkColumn(column, file);
  file->Append("\n");
}

}  // namespace geodesic::client
