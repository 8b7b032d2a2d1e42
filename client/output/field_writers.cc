#include "client/output/field_writers.h"

#include <array>
#include <bit>
#include <cstring>

#include "absl/strings/str_cat.h"
#include "client/output/number_text.h"

namespace geodesic::client {
void WriteNpy(const Column& column, AtomicFile* file, const std::string& mark) {
  file->Append(NpyHeader(NumpyName(column.type), column.shape(), 0, mark));
  AppendNumbers(column.values, column.type, file);
}

void WriteCsv(std::span<const Column> columns, AtomicFile* file) {
  CsvLine line;
  line.Text("vertex");
  for (const Column& column : columns) {
    for (const std::string& name : column.names()) line.Text(name);
  }
  file->Append(line.End());
  const size_t count = columns.empty() ? 0 : columns[0].count();
  for (size_t vertex = 0; vertex < count; ++vertex) {
    line.Number(vertex);
    for (const Column& column : columns) {
      for (size_t i = 0; i < column.components; ++i) {
        line.Text(
            TextOf(column.values[vertex * column.components + i], column.type));
      }
    }
    file->Append(line.End());
  }
}

void WritePly(const MeshArrays& mesh, std::span<const Column> columns,
              AtomicFile* file, const std::string& mark) {
  std::string header = absl::StrCat(
      "ply\nformat binary_little_endian 1.0\n", kUnitComment, "\n",
      mark.empty() ? "" : absl::StrCat("comment ", mark, "\n"),
      "element vertex ", mesh.positions.size(),
      "\nproperty double x\nproperty double y\nproperty double z\n");
  for (const Column& column : columns) {
    for (const std::string& name : column.names()) {
      header.append("property ").append(column.stored_name());
      header.append(" ").append(name).append("\n");
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
        AppendNumbers({&column.values[vertex * column.components + i], 1},
                      column.stored_type(), &row);
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
              AtomicFile* file, const std::string& mark) {
  file->Append(
      absl::StrCat("# vtk DataFile Version 3.0\ngeodesic distance field",
                   mark.empty() ? "" : absl::StrCat(", ", mark),
                   "\nBINARY\nDATASET POLYDATA\nPOINTS ", mesh.positions.size(),
                   " double\n"));
  std::string row;
  for (const Point& point : mesh.positions) {
    row.clear();
    AppendNumbers(point, NumberType::kFloat64, &row, std::endian::big);
    file->Append(row);
  }
  file->Append(absl::StrCat("\nPOLYGONS ", mesh.triangles.size(), " ",
                            4 * mesh.triangles.size(), "\n"));
  for (const Triangle& triangle : mesh.triangles) {
    const std::array<double, 4> polygon = {3, static_cast<double>(triangle[0]),
                                           static_cast<double>(triangle[1]),
                                           static_cast<double>(triangle[2])};
    row.clear();
    AppendNumbers(polygon, NumberType::kInt32, &row, std::endian::big);
    file->Append(row);
  }
  file->Append(absl::StrCat("\nPOINT_DATA ", mesh.positions.size()));
  for (const Column& column : columns) {
    const std::string type(column.stored_name());
    file->Append(
        column.components == 1
            ? absl::StrCat("\nSCALARS ", column.name, " ", type,
                           " 1\nLOOKUP_TABLE default\n")
            : absl::StrCat("\nVECTORS ", column.name, " ", type, "\n"));
    AppendNumbers(column.values, column.stored_type(), file, std::endian::big);
  }
  file->Append("\n");
}

}  // namespace geodesic::client
