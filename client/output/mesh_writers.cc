// The formats that hold the mesh and a scalar on it: .ply, .vtk.

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "absl/strings/str_cat.h"
#include "client/output/field_writers.h"

namespace geodesic::client {
namespace {

static_assert(std::endian::native == std::endian::little);

// The other byte order.
uint64_t Swapped(double value) {
  return __builtin_bswap64(std::bit_cast<uint64_t>(value));
}
uint32_t Swapped(uint32_t value) { return __builtin_bswap32(value); }

}  // namespace

void WritePly(const MeshArrays& mesh, std::span<const double> distances,
              AtomicFile* file) {
  file->Append(absl::StrCat(
      "ply\nformat binary_little_endian 1.0\n"
      "comment distances in the unit of the coordinates\n"
      "element vertex ",
      mesh.positions.size(),
      "\nproperty double x\nproperty double y\nproperty double z\n"
      "property double ",
      std::string(kScalarName), "\nelement face ", mesh.triangles.size(),
      "\nproperty list uchar int vertex_indices\nend_header\n"));
  for (size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    file->Append(&mesh.positions[vertex], sizeof(Point));
    file->Append(&distances[vertex], sizeof(double));
  }
  for (const Triangle& triangle : mesh.triangles) {
    std::array<char, 1 + sizeof(Triangle)> row = {3};
    std::memcpy(row.data() + 1, triangle.data(), sizeof(Triangle));
    file->Append(row.data(), row.size());
  }
}

void WriteVtk(const MeshArrays& mesh, std::span<const double> distances,
              AtomicFile* file) {
  file->Append(
      absl::StrCat("# vtk DataFile Version 3.0\ngeodesic distance field\n"
                   "BINARY\nDATASET POLYDATA\nPOINTS ",
                   mesh.positions.size(), " double\n"));
  for (const Point& point : mesh.positions) {
    const std::array<uint64_t, 3> row = {Swapped(point[0]), Swapped(point[1]),
                                         Swapped(point[2])};
    file->Append(row.data(), sizeof(row));
  }
  file->Append(absl::StrCat("\nPOLYGONS ", mesh.triangles.size(), " ",
                            4 * mesh.triangles.size(), "\n"));
  for (const Triangle& triangle : mesh.triangles) {
    const std::array<uint32_t, 4> row = {
        Swapped(uint32_t{3}), Swapped(triangle[0]), Swapped(triangle[1]),
        Swapped(triangle[2])};
    file->Append(row.data(), sizeof(row));
  }
  file->Append(absl::StrCat("\nPOINT_DATA ", distances.size(), "\nSCALARS ",
                            std::string(kScalarName),
                            " double 1\nLOOKUP_TABLE default\n"));
  for (const double distance : distances) {
    const uint64_t value = Swapped(distance);
    file->Append(&value, sizeof(value));
  }
  file->Append("\n");
}

}  // namespace geodesic::client
