#include "client/output/number_type.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

namespace geodesic::client {
namespace {

static_assert(std::endian::native == std::endian::little);

template <typename Number>
void AppendAs(std::span<const double> values, std::string* bytes) {
  const size_t had = bytes->size();
  bytes->resize(had + values.size() * sizeof(Number));
  char* to = bytes->data() + had;
  for (const double value : values) {
    const auto number = static_cast<Number>(value);
    std::memcpy(to, &number, sizeof(number));
    to += sizeof(number);
  }
}

}  // namespace

std::string_view NumpyName(NumberType type) {
  switch (type) {
    case NumberType::kFloat64:
      return "<f8";
    case NumberType::kFloat32:
      return "<f4";
    case NumberType::kInt64:
      return "<i8";
    case NumberType::kInt32:
      return "<i4";
  }
  return "";
}

void AppendNumbers(std::span<const double> values, NumberType type,
                   std::string* bytes) {
  switch (type) {
    case NumberType::kFloat64:
      return AppendAs<double>(values, bytes);
    case NumberType::kFloat32:
      return AppendAs<float>(values, bytes);
    case NumberType::kInt64:
      return AppendAs<int64_t>(values, bytes);
    case NumberType::kInt32:
      return AppendAs<int32_t>(values, bytes);
  }
}

void AppendNumbers(std::span<const double> values, NumberType type,
                   AtomicFile* file) {
  if (type == NumberType::kFloat64) {
    file->Append(values.data(), values.size_bytes());
    return;
  }
  constexpr size_t kBlock = size_t{1} << 16;
  std::string bytes;
  while (!values.empty()) {
    const size_t count = std::min(kBlock, values.size());
    bytes.clear();
    AppendNumbers(values.first(count), type, &bytes);
    file->Append(bytes);
    values = values.subspan(count);
  }
}

}  // namespace geodesic::client
