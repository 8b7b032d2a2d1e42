// The byte order of binary legacy VTK files.

#ifndef GEODESIC_CLIENT_OUTPUT_BIG_ENDIAN_H_
#define GEODESIC_CLIENT_OUTPUT_BIG_ENDIAN_H_

#include <bit>
#include <cstdint>

namespace geodesic::client {

static_assert(std::endian::native == std::endian::little);

inline uint64_t BigEndian(double value) {
  return __builtin_bswap64(std::bit_cast<uint64_t>(value));
}
inline uint32_t BigEndian(uint32_t value) { return __builtin_bswap32(value); }

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_BIG_ENDIAN_H_
