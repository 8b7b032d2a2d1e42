#include "bench/plain_ply.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <vector>

namespace geodesic {
namespace {

struct PlainHeader {
  uint64_t vertices = 0, faces = 0, vertex_bytes = 0;
};

std::optional<PlainHeader> ReadHeader(std::istream& file) {
  PlainHeader header;
  bool in_vertices = false, is_plain = true, is_binary = false;
  std::string line;
  while (std::getline(file, line) && line != "end_header") {
    is_binary = is_binary || line == "format binary_little_endian 1.0";
    if (line.starts_with("element vertex ")) {
      header.vertices = std::stoull(line.substr(15));
      in_vertices = true;
    } else if (line.starts_with("element face ")) {
      header.faces = std::stoull(line.substr(13));
      in_vertices = false;
    } else if (line.starts_with("property ") && in_vertices) {
      header.vertex_bytes += sizeof(float);
      is_plain = is_plain && line.starts_with("property float ");
    } else if (line.starts_with("property ")) {
      is_plain = is_plain && line.starts_with("property list uchar int ");
    }
  }
  if (!is_binary || !is_plain || header.vertex_bytes < 3 * sizeof(float)) {
    return std::nullopt;
  }
  return header;
}

}  // namespace

std::optional<TriangleSoup> ReadPlainPly(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::optional<PlainHeader> header = ReadHeader(file);
  if (!header.has_value()) return std::nullopt;
  TriangleSoup soup;
  soup.positions.resize(header->vertices);
  std::vector<float> row(header->vertex_bytes / sizeof(float));
  for (Point& position : soup.positions) {
    file.read(reinterpret_cast<char*>(row.data()),
              static_cast<std::streamsize>(header->vertex_bytes));
    std::copy_n(row.begin(), 3, position.begin());
  }
  soup.triangles.resize(header->faces);
  for (Triangle& triangle : soup.triangles) {
    char corners = 0;
    file.read(&corners, 1);
    file.read(reinterpret_cast<char*>(triangle.data()), sizeof(Triangle));
    if (corners != 3) return std::nullopt;
  }
  if (!file) return std::nullopt;
  return soup;
}

}  // namespace geodesic
