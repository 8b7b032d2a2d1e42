// Numbers in `bytes` fields, as they travel: little endian, doubles or floats.

#ifndef GEODESIC_CLIENT_WIRE_VALUES_H_
#define GEODESIC_CLIENT_WIRE_VALUES_H_

#include <bit>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geodesic_client/answer.h"

namespace geodesic::client {

// What is copied as it comes.
static_assert(std::endian::native == std::endian::little);

inline size_t SizeOf(ValueType type) {
  return type == ValueType::kFloat32 ? sizeof(float) : sizeof(double);
}

// Appends the values that `bytes` holds. False, and nothing is done, if it is
// not a whole number of them.
bool AppendValues(std::string_view bytes, ValueType type,
                  std::vector<double>* values);

// The same with numbers of vertices, columns or targets.
bool AppendNumbers(std::string_view bytes, std::vector<uint32_t>* numbers);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_WIRE_VALUES_H_
