#include "client/output/binary_numbers.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "absl/strings/str_cat.h"
#include "client/output/number_text.h"

namespace geodesic::client {
namespace {

static_assert(std::endian::native == std::endian::little);

template <typename Number>
void AppendAs(std::span<const double> values, std::endian order,
              std::string* bytes) {
  const size_t had = bytes->size();
  bytes->resize(had + values.size() * sizeof(Number));
  char* to = bytes->data() + had;
  for (const double value : values) {
    const auto number = static_cast<Number>(value);
    std::memcpy(to, &number, sizeof(number));
    if (order == std::endian::big) std::reverse(to, to + sizeof(number));
    to += sizeof(number);
  }
}

}  // namespace

std::string TextOf(double value, NumberType type) {
  if (IsInteger(type)) return NumberText(static_cast<int64_t>(value));
  if (type == NumberType::kFloat32) {
    return NumberText(static_cast<float>(value));
  }
  return NumberText(value);
}

void AppendNumbers(std::span<const double> values, NumberType type,
                   std::string* bytes, std::endian order) {
  switch (type) {
    case NumberType::kFloat64:
      return AppendAs<double>(values, order, bytes);
    case NumberType::kFloat32:
      return AppendAs<float>(values, order, bytes);
    case NumberType::kInt64:
      return AppendAs<int64_t>(values, order, bytes);
    case NumberType::kInt32:
      return AppendAs<int32_t>(values, order, bytes);
  }
}

void AppendNumbers(std::span<const double> values, NumberType type,
                   AtomicFile* file, std::endian order) {
  if (type == NumberType::kFloat64 && order == std::endian::native) {
    return file->Append(values.data(), values.size_bytes());
  }
  constexpr size_t kBlock = size_t{1} << 16;
  std::string bytes;
  while (!values.empty()) {
    const size_t count = std::min(kBlock, values.size());
    bytes.clear();
    AppendNumbers(values.first(count), type, &bytes, order);
    file->Append(bytes);
    values = values.subspan(count);
  }
}

std::string_view NumpyName(NumberType type) {
  constexpr std::array kNames = {"<f8", "<f4", "<i8", "<i4"};
  return kNames.at(static_cast<size_t>(type));
}

std::string_view PlyName(NumberType type) {
  return IsInteger(type)                ? "int"
         : type == NumberType::kFloat32 ? "float"
                                        : "double";
}

std::string NpyHeader(std::string_view type, std::span<const uint64_t> shape,
                      size_t least_size, std::string_view mark) {
  constexpr std::string_view kMagic("\x93NUMPY\x01\x00", 8);
  constexpr size_t kAlignment = 64;
  std::string dimensions;
  for (const uint64_t size : shape) {
    absl::StrAppend(&dimensions, dimensions.empty() ? "" : " ", size, ",");
  }
  // A Python tuple of one element needs its comma.
  if (shape.size() > 1) dimensions.pop_back();
  std::string text =
      absl::StrCat("{'descr': '", std::string(type),
                   "', 'fortran_order': False, 'shape': (", dimensions, "), }");
  if (!mark.empty()) absl::StrAppend(&text, "  # ", std::string(mark));
  // Magic, length and text with its newline fill whole blocks.
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
                     const std::vector<uint64_t>& shape,
                     std::string_view mark) {
  std::string bytes = NpyHeader(NumpyName(type), shape, 0, mark);
  AppendNumbers(values, type, &bytes);
  return bytes;
}

}  // namespace geodesic::client
