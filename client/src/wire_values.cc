#include "wire_values.h"

#include <cstring>

namespace geodesic::client {

bool AppendValues(std::string_view bytes, ValueType type,
                  std::vector<double>* values) {
  if (bytes.size() % SizeOf(type) != 0) return false;
  const size_t count = bytes.size() / SizeOf(type);
  const size_t had = values->size();
  values->resize(had + count);
  if (count == 0) return true;
  if (type == ValueType::kFloat64) {
    std::memcpy(values->data() + had, bytes.data(), bytes.size());
    return true;
  }
  for (size_t i = 0; i < count; ++i) {
    float value;
    std::memcpy(&value, bytes.data() + i * sizeof(value), sizeof(value));
    (*values)[had + i] = value;
  }
  return true;
}

bool AppendNumbers(std::string_view bytes, std::vector<uint32_t>* numbers) {
  if (bytes.size() % sizeof(uint32_t) != 0) return false;
  const size_t had = numbers->size();
  numbers->resize(had + bytes.size() / sizeof(uint32_t));
  if (!bytes.empty()) {
    std::memcpy(numbers->data() + had, bytes.data(), bytes.size());
  }
  return true;
}

}  // namespace geodesic::client
