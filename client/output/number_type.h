// Numbers in binary files, little endian.

#ifndef GEODESIC_CLIENT_OUTPUT_NUMBER_TYPE_H_
#define GEODESIC_CLIENT_OUTPUT_NUMBER_TYPE_H_

#include <span>
#include <string>
#include <string_view>

#include "client/output/atomic_file.h"

namespace geodesic::client {

enum class NumberType { kFloat64, kFloat32, kInt64, kInt32 };

// As NumPy writes it: "<f8", "<f4", "<i8" or "<i4".
std::string_view NumpyName(NumberType type);

// Appends the values in this type. REQUIRES: integers are in range.
void AppendNumbers(std::span<const double> values, NumberType type,
                   std::string* bytes);

// The same, a block at a time.
void AppendNumbers(std::span<const double> values, NumberType type,
                   AtomicFile* file);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_NUMBER_TYPE_H_
