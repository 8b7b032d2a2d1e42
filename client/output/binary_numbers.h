// Numbers in binary files, and NumPy files (format 1.0).

#ifndef GEODESIC_CLIENT_OUTPUT_BINARY_NUMBERS_H_
#define GEODESIC_CLIENT_OUTPUT_BINARY_NUMBERS_H_

#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "client/output/atomic_file.h"

namespace geodesic::client {

enum class NumberType { kFloat64, kFloat32, kInt64, kInt32 };

inline bool IsInteger(NumberType type) {
  return type == NumberType::kInt64 || type == NumberType::kInt32;
}

// The fewest digits that give the value, converted to `type`, again.
std::string TextOf(double value, NumberType type);

// Appends the values, converted to `type`.
// REQUIRES: they are in its range if it is an integer type.
void AppendNumbers(std::span<const double> values, NumberType type,
                   std::string* bytes, std::endian order = std::endian::little);

// The same into a file, a block at a time.
void AppendNumbers(std::span<const double> values, NumberType type,
                   AtomicFile* file, std::endian order = std::endian::little);

// NumPy's name of the type: "<f8", "<f4", "<i8" or "<i4".
std::string_view NumpyName(NumberType type);

// What .ply and legacy .vtk call the type: "double", "float" or "int".
// REQUIRES: not kInt64, which .ply lacks.
std::string_view PlyName(NumberType type);

// The part of a file before the values. `type` is NumPy's name. The size is a
// multiple of 64 bytes and at least `least_size`. A `mark` stands behind the
// header's dictionary as a comment, which NumPy skips.
std::string NpyHeader(std::string_view type, std::span<const uint64_t> shape,
                      size_t least_size = 0, std::string_view mark = "");

// A whole file in memory.
// REQUIRES: as many values as the shape has.
std::string NpyArray(std::span<const double> values, NumberType type,
                     const std::vector<uint64_t>& shape,
                     std::string_view mark = "");

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_BINARY_NUMBERS_H_
