// Numbers in `bytes` fields, as they travel: little endian, doubles or floats.

#ifndef GEODESIC_CLIENT_WIRE_VALUES_H_
#define GEODESIC_CLIENT_WIRE_VALUES_H_

#include <bit>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <vector>

#include "geodesic_client/answer.h"

namespace geodesic::client {

// Numbers are copied as they come.
static_assert(std::endian::native == std::endian::little);

// Appends the elements that `bytes` holds. Returns false, and does nothing, if
// it holds a part of one.
template <typename Element>
bool AppendElements(std::string_view bytes, std::vector<Element>* elements) {
  static_assert(std::is_trivially_copyable_v<Element>);
  if (bytes.size() % sizeof(Element) != 0) return false;
  const size_t had = elements->size();
  elements->resize(had + bytes.size() / sizeof(Element));
  if (!bytes.empty()) {
    std::memcpy(elements->data() + had, bytes.data(), bytes.size());
  }
  return true;
}

// The same for real numbers, which may travel as floats. A `Value` is a double
// or an array of doubles.
template <typename Value>
bool AppendValues(std::string_view bytes, ValueType type,
                  std::vector<Value>* values) {
  if (type == ValueType::kFloat64) return AppendElements(bytes, values);
  std::vector<float> floats;
  if (!AppendElements(bytes, &floats)) return false;
  const std::vector<double> doubles(floats.begin(), floats.end());
  return AppendElements({reinterpret_cast<const char*>(doubles.data()),
                         doubles.size() * sizeof(double)},
                        values);
}

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_WIRE_VALUES_H_
