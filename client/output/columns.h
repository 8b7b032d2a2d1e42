// What a file may hold about every vertex.

#ifndef GEODESIC_CLIENT_OUTPUT_COLUMNS_H_
#define GEODESIC_CLIENT_OUTPUT_COLUMNS_H_

#include <string>
#include <vector>

#include "client/output/number_type.h"

namespace geodesic::client {

// The names of columns, in every format that has names.
inline constexpr char kDistanceColumn[] = "geodesic_distance";
inline constexpr char kNearestSourceColumn[] = "nearest_source";
inline constexpr char kGradientColumn[] = "gradient";

struct Column {
  std::string name;
  // `components` for each vertex, one vertex after the other.
  std::vector<double> values;
  size_t components = 1;  // or 3, a vector
  NumberType type = NumberType::kFloat64;

  bool is_integer() const {
    return type == NumberType::kInt64 || type == NumberType::kInt32;
  }
  size_t count() const { return values.size() / components; }
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_COLUMNS_H_
