#include "readers/ply_scalar.h"

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string_view>

#include "readers/byte_order.h"

namespace geodesic {
namespace {

struct ScalarName {
  std::string_view name;
  PlyScalar type;
};

constexpr std::array<ScalarName, 16> kNames = {{
    {"char", PlyScalar::kInt8},
    {"int8", PlyScalar::kInt8},
    {"uchar", PlyScalar::kUint8},
    {"uint8", PlyScalar::kUint8},
    {"short", PlyScalar::kInt16},
    {"int16", PlyScalar::kInt16},
    {"ushort", PlyScalar::kUint16},
    {"uint16", PlyScalar::kUint16},
    {"int", PlyScalar::kInt32},
    {"int32", PlyScalar::kInt32},
    {"uint", PlyScalar::kUint32},
    {"uint32", PlyScalar::kUint32},
    {"float", PlyScalar::kFloat32},
    {"float32", PlyScalar::kFloat32},
    {"double", PlyScalar::kFloat64},
    {"float64", PlyScalar::kFloat64},
}};

template <typename Result, typename Stored, std::endian kOrder>
Result LoadAs(const char* address) {
  return static_cast<Result>(Load<Stored, kOrder>(address));
}

template <typename Result, typename Stored>
Result (*Pick(bool big_endian))(const char*) {
  return big_endian ? LoadAs<Result, Stored, std::endian::big>
                    : LoadAs<Result, Stored, std::endian::little>;
}

template <typename Result>
Result (*Loader(PlyScalar type, bool big_endian))(const char*) {
  switch (type) {
    case PlyScalar::kInt8:
      return Pick<Result, int8_t>(big_endian);
    case PlyScalar::kUint8:
      return Pick<Result, uint8_t>(big_endian);
    case PlyScalar::kInt16:
      return Pick<Result, int16_t>(big_endian);
    case PlyScalar::kUint16:
      return Pick<Result, uint16_t>(big_endian);
    case PlyScalar::kInt32:
      return Pick<Result, int32_t>(big_endian);
    case PlyScalar::kUint32:
      return Pick<Result, uint32_t>(big_endian);
    case PlyScalar::kFloat32:
      return Pick<Result, float>(big_endian);
    case PlyScalar::kFloat64:
      break;
  }
  return Pick<Result, double>(big_endian);
}

}  // namespace

std::optional<PlyScalar> PlyScalarFromName(std::string_view name) {
  for (const ScalarName& known : kNames) {
    if (known.name == name) return known.type;
  }
  return std::nullopt;
}

size_t SizeOf(PlyScalar type) {
  switch (type) {
    case PlyScalar::kInt8:
    case PlyScalar::kUint8:
      return 1;
    case PlyScalar::kInt16:
    case PlyScalar::kUint16:
      return 2;
    case PlyScalar::kInt32:
    case PlyScalar::kUint32:
    case PlyScalar::kFloat32:
      return 4;
    case PlyScalar::kFloat64:
      break;
  }
  return 8;
}

LoadDouble DoubleLoader(PlyScalar type, bool big_endian) {
  return Loader<double>(type, big_endian);
}

LoadInteger IntegerLoader(PlyScalar type, bool big_endian) {
  return Loader<int64_t>(type, big_endian);
}

}  // namespace geodesic
