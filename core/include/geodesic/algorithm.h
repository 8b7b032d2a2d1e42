// The algorithms on offer: each is a propagation rule driven by a queue.
//
// All of them compute the same distances (Xu et al. 2015, Proposition 1: the
// order in which windows are propagated does not matter); they differ in cost.

#ifndef GEODESIC_ALGORITHM_H_
#define GEODESIC_ALGORITHM_H_

#include <array>
#include <cstddef>
#include <string_view>

#include "absl/status/statusor.h"

namespace geodesic {

// The one list of algorithms; the first is the default. An entry holds the
// enumerator, the name in command lines and messages, the rule (solver/rules),
// the queue (solver/queues), the algorithm with the same queue whose windows
// are trimmed against each other, and a summary.
#define GEODESIC_ALGORITHMS(X)                                                \
  X(FwpList, "fwp-list", ListRule, FwpBuckets, FwpMmp,                        \
    "Lists of windows, trimmed and propagated together, in FWP buckets")      \
  X(FwpCh, "fwp-ch", IchRule, FwpBuckets, FwpMmp,                             \
    "Chen-Han windows with the Xin-Wang filter in FWP buckets")               \
  X(FwpMmp, "fwp-mmp", MmpRule, FwpBuckets, FwpMmp,                           \
    "MMP windows, trimmed against each other, in FWP buckets")                \
  X(Ich, "ich", IchRule, BinaryHeap, Mmp,                                     \
    "Chen-Han windows with the Xin-Wang filter in a binary heap")             \
  X(Mmp, "mmp", MmpRule, BinaryHeap, Mmp,                                     \
    "MMP windows, trimmed against each other, in a binary heap")              \
  X(LcCh, "lc-ch", IchRule, LabelCorrecting, LcMmp,                           \
    "Chen-Han windows with the Xin-Wang filter in a label-correcting queue")  \
  X(LcMmp, "lc-mmp", MmpRule, LabelCorrecting, LcMmp,                         \
    "MMP windows, trimmed against each other, in a label-correcting queue")   \
  X(Ch, "ch", ChRule, Fifo, Mmp,                                              \
    "Chen-Han windows without a filter, first in first out: for comparison, " \
    "the slowest by far")

// An exact algorithm.
enum class Algorithm {
#define GEODESIC_ENUMERATOR(id, ...) k##id,
  GEODESIC_ALGORITHMS(GEODESIC_ENUMERATOR)
#undef GEODESIC_ENUMERATOR
};

// What is known of an algorithm; with_trimming names its MMP variant.
struct AlgorithmInfo {
  Algorithm algorithm;
  std::string_view name;
  Algorithm with_trimming;
  std::string_view summary;
};

// All exact algorithms; the first is the default.
inline constexpr auto kAlgorithms = std::to_array<AlgorithmInfo>({
#define GEODESIC_INFO(id, name, rule, queue, with_trimming, summary) \
  {Algorithm::k##id, name, Algorithm::k##with_trimming, summary},
    GEODESIC_ALGORITHMS(GEODESIC_INFO)
#undef GEODESIC_INFO
});
inline constexpr Algorithm kDefaultAlgorithm = kAlgorithms[0].algorithm;

// Its name in command lines and messages.
constexpr std::string_view AlgorithmName(Algorithm algorithm) {
  return kAlgorithms[static_cast<size_t>(algorithm)].name;
}

// The algorithm with MMP's rule and the same queue.
constexpr Algorithm WithTrimming(Algorithm algorithm) {
  return kAlgorithms[static_cast<size_t>(algorithm)].with_trimming;
}

// Errors: INVALID_ARGUMENT naming `name` and the names that are known.
absl::StatusOr<Algorithm> AlgorithmFromName(std::string_view name);

}  // namespace geodesic

#endif  // GEODESIC_ALGORITHM_H_
