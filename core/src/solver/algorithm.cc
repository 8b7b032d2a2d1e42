#include "geodesic/algorithm.h"

#include <string>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"

namespace geodesic {

absl::StatusOr<Algorithm> AlgorithmFromName(std::string_view name) {
  for (const AlgorithmInfo& info : kAlgorithms) {
    if (info.name == name) return info.algorithm;
  }
  const std::string known = absl::StrJoin(
      kAlgorithms, ", ", [](std::string* out, const AlgorithmInfo& info) {
        out->append(info.name);
      });
  return absl::InvalidArgumentError(absl::StrCat(
      "unknown algorithm \"", std::string(name), "\"; known are: ", known));
}

}  // namespace geodesic
