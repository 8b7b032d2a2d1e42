#include "client/output/npy.h"

#include <algorithm>

#include "absl/strings/str_cat.h"

namespace geodesic::client {

std::string NpyHeader(std::string_view type, std::span<const uint64_t> shape,
                      size_t least_size) {
  constexpr std::string_view kMagic("\x93NUMPY\x01\x00", 8);
  constexpr size_t kAlignment = 64;
  std::string dimensions;
  for (const uint64_t size : shape) {
    absl::StrAppend(&dimensions, dimensions.empty() ? "" : " ", size, ",");
  }
  // A tuple of one keeps its comma, longer ones end without.
  if (shape.size() > 1) dimensions.pop_back();
  std::string text =
      absl::StrCat("{'descr': '", std::string(type),
                   "', 'fortran_order': False, 'shape': (", dimensions, "), }");
  // Magic, length and text, ended by a newline, fill whole blocks.
  const size_t prefix = kMagic.size() + sizeof(uint16_t);
  const size_t unpadded = std::max(prefix + text.size() + 1, least_size);
  const size_t size = (unpadded + kAlignment - 1) / kAlignment * kAlignment;
  text.resize(size - prefix - 1, ' ');
  text.push_back('\n');
  const auto length = static_cast<uint16_t>(text.size());
  std::string header(kMagic);
  header.append(reinterpret_cast<const char*>(&length), sizeof(length));
  return header + text;
}

std::string NpyArray(std::span<const double> values, NumberType type,
                     const std::vector<uint64_t>& shape) {
  std::string bytes = NpyHeader(NumpyName(type), shape);
  AppendNumbers(values, type, &bytes);
  return bytes;
}

}  // namespace geodesic::client
