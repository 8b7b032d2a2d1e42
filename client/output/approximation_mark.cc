#include "client/output/approximation_mark.h"

#include "absl/strings/str_cat.h"
#include "client/output/number_text.h"

namespace geodesic::client {
namespace {

constexpr char kApproximate[] = "approximate: ";
constexpr char kWithin[] = "within ";
constexpr char kRelative[] = " (relative error)";

}  // namespace

std::string AlgorithmText(const std::string& algorithm,
                          const Approximation& approximation) {
  std::string text = algorithm;
  const auto add = [&](const char* name, const auto& value) {
    if (value.has_value()) {
      absl::StrAppend(&text, ", ", name, " ", NumberText(*value));
    }
  };
  add("lambda", approximation.lambda);
  add("K", approximation.neighbours);
  add("samples", approximation.samples);
  return text;
}

std::string ApproximationMark(const std::string& algorithm,
                              const Approximation& approximation) {
  return IsApproximate(algorithm)
             ? kApproximate + AlgorithmText(algorithm, approximation)
             : "";
}

std::string ToleranceMark(double tolerance) {
  return tolerance == 0
             ? ""
             : absl::StrCat(kWithin, NumberText(tolerance), kRelative);
}

bool IsToleranceMark(const std::string& mark) {
  return mark.starts_with(kWithin);
}

bool IsMark(const std::string& text) {
  return text.starts_with(kApproximate) ||
         (IsToleranceMark(text) && text.ends_with(kRelative));
}

std::string MarkedName(const std::string& exact, const std::string& mark) {
  if (mark.empty()) return exact;
  return IsToleranceMark(mark) ? exact + "_within_tolerance"
                               : "approximate_" + exact;
}

}  // namespace geodesic::client
