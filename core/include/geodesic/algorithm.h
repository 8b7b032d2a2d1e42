// The algorithms on offer: each is a propagation rule driven by a queue.
//
// All of them compute the same distances (Xu et al. 2015, Proposition 1: the
// order in which windows are propagated does not matter); they differ in cost.

#ifndef GEODESIC_ALGORITHM_H_
#define GEODESIC_ALGORITHM_H_

#include <array>
#include <string_view>

#include "absl/status/statusor.h"

namespace geodesic {

enum class Algorithm {
  kFwpList,  // Lists of windows that cross a face together, FWP buckets.
  kFwpCh,    // Chen-Han rule with the Xin-Wang filter, FWP buckets.
  kFwpMmp,   // Mitchell-Mount-Papadimitriou rule, FWP buckets.
  kIch,      // Chen-Han rule with the Xin-Wang filter, binary heap.
  kMmp,      // Mitchell-Mount-Papadimitriou rule, binary heap.
  kLcCh,     // Chen-Han rule with the Xin-Wang filter, label-correcting queue.
  kLcMmp,    // Mitchell-Mount-Papadimitriou rule, label-correcting queue.
  kCh,       // Chen-Han rule without the filter, first in first out.
};

struct AlgorithmInfo {
  Algorithm algorithm;
  std::string_view name;  // as command lines and messages spell it
  std::string_view summary;
};

// The one list of algorithms; the first is the default.
inline constexpr std::array<AlgorithmInfo, 8> kAlgorithms = {{
    {Algorithm::kFwpList, "fwp-list",
     "Lists of windows, trimmed and propagated together, in FWP buckets"},
    {Algorithm::kFwpCh, "fwp-ch",
     "Chen-Han windows with the Xin-Wang filter in FWP buckets"},
    {Algorithm::kFwpMmp, "fwp-mmp",
     "MMP windows, trimmed against each other, in FWP buckets"},
    {Algorithm::kIch, "ich",
     "Chen-Han windows with the Xin-Wang filter in a binary heap"},
    {Algorithm::kMmp, "mmp",
     "MMP windows, trimmed against each other, in a binary heap"},
    {Algorithm::kLcCh, "lc-ch",
     "Chen-Han windows with the Xin-Wang filter in a label-correcting queue"},
    {Algorithm::kLcMmp, "lc-mmp",
     "MMP windows, trimmed against each other, in a label-correcting queue"},
    {Algorithm::kCh, "ch",
     "Chen-Han windows without a filter, first in first out: for comparison, "
     "the slowest by far"},
}};
inline constexpr Algorithm kDefaultAlgorithm = kAlgorithms[0].algorithm;

std::string_view AlgorithmName(Algorithm algorithm);

// The algorithm with the same queue that trims windows against each other: the
// MMP rule in place of Chen and Han's.
Algorithm WithTrimming(Algorithm algorithm);

// Errors: INVALID_ARGUMENT naming `name` and the names that are known.
absl::StatusOr<Algorithm> AlgorithmFromName(std::string_view name);

}  // namespace geodesic

#endif  // GEODESIC_ALGORITHM_H_
