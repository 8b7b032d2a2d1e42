// The formats that hold the values only: .npy, .csv, .f64.

#include <bit>
#include <charconv>
#include <cstdint>
#include <string>

#include "absl/strings/str_cat.h"
#include "client/output/field_writers.h"

namespace geodesic::client {
namespace {

static_assert(std::endian::native == std::endian::little);

}  // namespace

void WriteNpy(std::span<const double> distances, AtomicFile* file) {
  constexpr std::string_view kMagic("\x93NUMPY\x01\x00", 8);
  constexpr size_t kAlignment = 64;
  std::string header =
      absl::StrCat("{'descr': '<f8', 'fortran_order': False, 'shape': (",
                   distances.size(), ",), }");
  // Magic, length and header, ended by a newline, fill whole blocks.
  const size_t unpadded = kMagic.size() + sizeof(uint16_t) + header.size() + 1;
  header.append((kAlignment - unpadded % kAlignment) % kAlignment, ' ');
  header.push_back('\n');
  const auto length = static_cast<uint16_t>(header.size());
  file->Append(kMagic);
  file->Append(&length, sizeof(length));
  file->Append(header);
  WriteRaw(distances, file);
}

void WriteCsv(std::span<const double> distances, AtomicFile* file) {
  file->Append("vertex,");
  file->Append(kScalarName);
  file->Append("\n");
  // An index, a comma, a double's longest shortest form, a newline.
  char line[64];
  for (size_t vertex = 0; vertex < distances.size(); ++vertex) {
    char* end = std::to_chars(line, line + sizeof(line), vertex).ptr;
    *end++ = ',';
    end = std::to_chars(end, line + sizeof(line) - 1, distances[vertex]).ptr;
    *end++ = '\n';
    file->Append(line, static_cast<size_t>(end - line));
  }
}

void WriteRaw(std::span<const double> distances, AtomicFile* file) {
  file->Append(distances.data(), distances.size_bytes());
}

}  // namespace geodesic::client
