// The approximate methods on offer: systems that the paper (Xu et al. 2015,
// section 7) compares itself with. They are a list of their own, apart from the
// algorithms of algorithm.h, which are exact: no answer of theirs is a
// DistanceField, and nothing that asks for an Algorithm can name one.

#ifndef GEODESIC_APPROXIMATE_METHOD_H_
#define GEODESIC_APPROXIMATE_METHOD_H_

#include <array>
#include <cstddef>
#include <string_view>

#include "absl/status/statusor.h"

namespace geodesic {

// The one list of approximate methods. An entry holds the enumerator, the name
// in command lines and messages, and a summary.
#define GEODESIC_APPROXIMATE_METHODS(X)                                     \
  X(Fmm, "fmm",                                                             \
    "Fast marching: planar fronts from face to face, in a binary heap")     \
  X(FmmUntidy, "fmm-untidy",                                                \
    "Fast marching in buckets that are not sorted inside")                  \
  X(Heat, "heat",                                                           \
    "The heat method: two sparse linear systems, factorized once")          \
  X(Svg, "svg",                                                             \
    "The saddle vertex graph: Dijkstra over direct geodesics between near " \
    "vertices")                                                             \
  X(Gtu, "gtu",                                                             \
    "Geodesic triangle unfolding: fields of samples, laid into the plane")

// An approximate method.
enum class ApproximateMethod {
#define GEODESIC_ENUMERATOR(id, ...) k##id,
  GEODESIC_APPROXIMATE_METHODS(GEODESIC_ENUMERATOR)
#undef GEODESIC_ENUMERATOR
};

// What is known of a method.
struct ApproximateMethodInfo {
  ApproximateMethod method;
  std::string_view name;
  std::string_view summary;
};

// All approximate methods.
inline constexpr auto kApproximateMethods =
    std::to_array<ApproximateMethodInfo>({
#define GEODESIC_INFO(id, name, summary) \
  {ApproximateMethod::k##id, name, summary},
        GEODESIC_APPROXIMATE_METHODS(GEODESIC_INFO)
#undef GEODESIC_INFO
    });

// Its name in command lines and messages.
constexpr std::string_view ApproximateMethodName(ApproximateMethod method) {
  return kApproximateMethods[static_cast<size_t>(method)].name;
}

// Errors: INVALID_ARGUMENT naming `name` and the names that are known.
absl::StatusOr<ApproximateMethod> ApproximateMethodFromName(
    std::string_view name);

}  // namespace geodesic

#endif  // GEODESIC_APPROXIMATE_METHOD_H_
