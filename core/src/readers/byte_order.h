// Numbers from bytes at any address, in either byte order.

#ifndef GEODESIC_READERS_BYTE_ORDER_H_
#define GEODESIC_READERS_BYTE_ORDER_H_

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace geodesic {

// The number of type T stored in the sizeof(T) bytes at `address`.
template <typename T, std::endian kOrder>
T Load(const char* address) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), address, bytes.size());
  if constexpr (kOrder != std::endian::native) {
    std::reverse(bytes.begin(), bytes.end());
  }
  return std::bit_cast<T>(bytes);
}

}  // namespace geodesic

#endif  // GEODESIC_READERS_BYTE_ORDER_H_
