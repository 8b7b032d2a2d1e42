#include "geodesic/algorithm.h"

#include <string>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"

namespace geodesic {

std::string_view AlgorithmName(Algorithm algorithm) {
  for (const AlgorithmInfo& info : kAlgorithms) {
    if (info.algorithm == algorithm) return info.name;
  }
  return "unknown";
}

Algorithm WithTrimming(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::kFwpCh:
    case Algorithm::kFwpList:
      return Algorithm::kFwpMmp;
    case Algorithm::kIch:
    case Algorithm::kCh:
      return Algorithm::kMmp;
    case Algorithm::kLcCh:
      return Algorithm::kLcMmp;
    case Algorithm::kFwpMmp:
    case Algorithm::kMmp:
    case Algorithm::kLcMmp:
      return algorithm;
  }
  return algorithm;
}

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
