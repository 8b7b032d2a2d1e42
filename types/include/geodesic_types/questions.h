// The questions, and what each of them takes.

#ifndef GEODESIC_TYPES_QUESTIONS_H_
#define GEODESIC_TYPES_QUESTIONS_H_

#include <array>
#include <string>
#include <string_view>
#include <variant>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic_types/algorithms.h"
#include "geodesic_types/field_path.h"

namespace geodesic {

// What is known of a question.
struct QuestionInfo {
  std::string_view name;  // of its method in the protocol
  bool takes_tolerance;
  bool takes_approximate;  // algorithms
  bool takes_exact;        // algorithms other than the default one
};

// The one list of questions.
inline constexpr auto kQuestions = std::to_array<QuestionInfo>({
    {"ComputeField", true, true, true},
    {"ComputePaths", false, false, true},
    {"ComputePairs", true, true, false},
    {"ComputeMatrix", true, true, true},
    {"FindNearest", true, true, true},
    {"ComputeIsolines", true, false, true},
    {"SampleFarthestPoints", true, false, true},
    {"ComputeLogMap", false, false, true},
    {"TraceLines", false, false, false},
});

// The range of tolerances other than 0.
inline constexpr double kLeastTolerance = 1e-9;
inline constexpr double kMostTolerance = 0.1;

// What is known of the question with this name. REQUIRES: there is one.
constexpr const QuestionInfo& QuestionNamed(std::string_view name) {
  size_t i = 0;
  while (kQuestions[i].name != name) ++i;
  return kQuestions[i];
}

// Whether the question takes this algorithm and this tolerance (0: exact).
// Errors: INVALID_ARGUMENT with the path "algorithm" or "tolerance".
inline absl::Status CheckAlgorithm(const QuestionInfo& question,
                                   const AlgorithmChoice& choice,
                                   double tolerance) {
  const auto refuse = [](const char* field, const std::string& what) {
    return InvalidField(field, absl::StrCat(field, ": ", what));
  };
  const std::string asked(question.name);
  const auto* method = std::get_if<MethodChoice>(&choice);
  const auto* exact = std::get_if<Algorithm>(&choice);
  const std::string name(method != nullptr
                             ? ApproximateMethodName(method->method)
                             : AlgorithmName(*exact));
  if (tolerance != 0 && !question.takes_tolerance) {
    return refuse("tolerance", asked + " answers exactly; leave it out");
  }
  if (tolerance != 0 && choice != AlgorithmChoice(Algorithm::kFwpList)) {
    return refuse(
        "tolerance",
        absl::StrCat(name,
                     method != nullptr
                         ? " is approximate and certifies nothing"
                         : " merges no windows and takes no tolerance",
                     "; name no algorithm beside it, or fwp-list"));
  }
  if (exact != nullptr && *exact != kDefaultAlgorithm &&
      !question.takes_exact) {
    return refuse("algorithm", absl::StrCat(asked,
                                            " finds exact distances by the "
                                            "default algorithm; leave it out "
                                            "or name an approximate one"));
  }
  if (method == nullptr || question.takes_approximate) return absl::OkStatus();
  std::string others;
  for (const QuestionInfo& other : kQuestions) {
    if (!other.takes_approximate) continue;
    absl::StrAppend(&others, others.empty() ? "" : ", ",
                    std::string(other.name));
  }
  return refuse("algorithm",
                absl::StrCat(name, " is approximate, and ", asked,
                             " answers exactly: name an exact algorithm or "
                             "none; ",
                             others, " take approximate ones"));
}

}  // namespace geodesic

#endif  // GEODESIC_TYPES_QUESTIONS_H_
