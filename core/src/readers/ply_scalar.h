// The scalar types of PLY and how binary files store them.

#ifndef GEODESIC_READERS_PLY_SCALAR_H_
#define GEODESIC_READERS_PLY_SCALAR_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace geodesic {

enum class PlyScalar {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kFloat32,
  kFloat64,
};

// "uchar", "uint8", ...; nothing for an unknown name.
std::optional<PlyScalar> PlyScalarFromName(std::string_view name);

size_t SizeOf(PlyScalar type);

inline bool IsInteger(PlyScalar type) {
  return type != PlyScalar::kFloat32 && type != PlyScalar::kFloat64;
}

// Functions that read SizeOf(type) bytes at any address. LoadDouble is exact
// for every type.
using LoadDouble = double (*)(const char*);
using LoadInteger = int64_t (*)(const char*);
LoadDouble DoubleLoader(PlyScalar type, bool big_endian);
// REQUIRES: IsInteger(type).
LoadInteger IntegerLoader(PlyScalar type, bool big_endian);

}  // namespace geodesic

#endif  // GEODESIC_READERS_PLY_SCALAR_H_
