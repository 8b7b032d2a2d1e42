// NumPy's array files, format 1.0.

#ifndef GEODESIC_CLIENT_OUTPUT_NPY_H_
#define GEODESIC_CLIENT_OUTPUT_NPY_H_

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "client/output/number_type.h"

namespace geodesic::client {

// All that comes before the values; `type` as NumPy names it. Whole blocks of
// 64 bytes, and at least `least_size`.
std::string NpyHeader(std::string_view type, std::span<const uint64_t> shape,
                      size_t least_size = 0);

// A whole file in memory. REQUIRES: as many values as the shape has.
std::string NpyArray(std::span<const double> values, NumberType type,
                     const std::vector<uint64_t>& shape);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_NPY_H_
