// The algorithms on offer: exact ones, and approximate methods.
//
// An exact algorithm is a propagation rule driven by a queue. All of them
// compute the same distances (Xu et al. 2015, Proposition 1: the order in which
// windows are propagated does not matter); they differ in cost.
//
// Approximate methods are systems that the paper (section 7) compares itself
// with. They are a list of their own: no answer of theirs is a DistanceField,
// and nothing that asks for an Algorithm can name one.

#ifndef GEODESIC_TYPES_ALGORITHMS_H_
#define GEODESIC_TYPES_ALGORITHMS_H_

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"

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

// The one list of approximate methods. An entry holds the enumerator, the name
// in command lines and messages, the parameter that it takes, and a summary.
#define GEODESIC_APPROXIMATE_METHODS(X)                                     \
  X(Fmm, "fmm", kNone,                                                      \
    "Fast marching: planar fronts from face to face, in a binary heap")     \
  X(FmmUntidy, "fmm-untidy", kNone,                                         \
    "Fast marching in buckets that are not sorted inside")                  \
  X(Heat, "heat", kLambda,                                                  \
    "The heat method: two sparse linear systems, factorized once")          \
  X(Svg, "svg", kNeighbours,                                                \
    "The saddle vertex graph: Dijkstra over direct geodesics between near " \
    "vertices")                                                             \
  X(Gtu, "gtu", kSamples,                                                   \
    "Geodesic triangle unfolding: fields of samples, laid into the plane")

// An approximate method.
enum class ApproximateMethod {
#define GEODESIC_ENUMERATOR(id, ...) k##id,
  GEODESIC_APPROXIMATE_METHODS(GEODESIC_ENUMERATOR)
#undef GEODESIC_ENUMERATOR
};

// What a method can be told.
enum class MethodParameter { kNone, kLambda, kNeighbours, kSamples };

// What is known of a method.
struct ApproximateMethodInfo {
  ApproximateMethod method;
  std::string_view name;
  MethodParameter parameter;
  std::string_view summary;
};

// All approximate methods.
inline constexpr auto kApproximateMethods =
    std::to_array<ApproximateMethodInfo>({
#define GEODESIC_INFO(id, name, parameter, summary) \
  {ApproximateMethod::k##id, name, MethodParameter::parameter, summary},
        GEODESIC_APPROXIMATE_METHODS(GEODESIC_INFO)
#undef GEODESIC_INFO
    });

// What is known of one.
constexpr const ApproximateMethodInfo& InfoOf(ApproximateMethod method) {
  return kApproximateMethods[static_cast<size_t>(method)];
}

// Its name in command lines and messages.
constexpr std::string_view ApproximateMethodName(ApproximateMethod method) {
  return InfoOf(method).name;
}

// A method with the parameters that change its distances; those of other
// methods have their defaults, so that equal choices are the same.
struct MethodChoice {
  ApproximateMethod method = ApproximateMethod::kFmm;
  // heat: it spreads for lambda times the square of the mean edge length.
  double lambda = 1;
  // svg: how many vertices around each one are looked at.
  uint32_t neighbours = 50;
  // gtu: how many vertices' exact fields are kept.
  uint32_t samples = 200;

  friend auto operator<=>(const MethodChoice&, const MethodChoice&) = default;
};

// By what distances are found.
using AlgorithmChoice = std::variant<Algorithm, MethodChoice>;

// The entry of a list that has this name. Errors: INVALID_ARGUMENT naming
// `name` and the names that are known; `what` is what they name.
template <typename List>
auto EntryNamed(const List& list, std::string_view name, const char* what)
    -> absl::StatusOr<typename List::value_type> {
  for (const auto& info : list) {
    if (info.name == name) return info;
  }
  return absl::InvalidArgumentError(absl::StrCat(
      "unknown ", what, " \"", std::string(name), "\"; known are: ",
      absl::StrJoin(list, ", ", [](std::string* out, const auto& info) {
        out->append(info.name);
      })));
}

// Errors: as EntryNamed.
inline absl::StatusOr<Algorithm> AlgorithmFromName(std::string_view name) {
  const auto info = EntryNamed(kAlgorithms, name, "algorithm");
  if (!info.ok()) return info.status();
  return info->algorithm;
}
inline absl::StatusOr<ApproximateMethod> ApproximateMethodFromName(
    std::string_view name) {
  const auto info = EntryNamed(kApproximateMethods, name, "approximate method");
  if (!info.ok()) return info.status();
  return info->method;
}

}  // namespace geodesic

#endif  // GEODESIC_TYPES_ALGORITHMS_H_
