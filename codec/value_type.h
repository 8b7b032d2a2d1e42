// How the numbers of answers (geodesic/v1/answer.proto) lie in memory.

#ifndef GEODESIC_CODEC_VALUE_TYPE_H_
#define GEODESIC_CODEC_VALUE_TYPE_H_

#include <bit>
#include <cstdint>

#include "geodesic/v1/query.pb.h"

namespace geodesic::codec {

// Numbers travel as they lie in memory.
static_assert(std::endian::native == std::endian::little);

// The bytes of a number; 0 if the type is not known.
inline uint32_t SizeOf(v1::ValueType type) {
  switch (type) {
    case v1::VALUE_TYPE_UINT8:
      return 1;
    case v1::VALUE_TYPE_FLOAT32:
    case v1::VALUE_TYPE_UINT32:
      return 4;
    case v1::VALUE_TYPE_FLOAT64:
    case v1::VALUE_TYPE_UINT64:
      return 8;
    default:
      return 0;
  }
}

}  // namespace geodesic::codec

#endif  // GEODESIC_CODEC_VALUE_TYPE_H_
