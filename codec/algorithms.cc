#include "codec/algorithms.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "geodesic_types/field_path.h"

namespace geodesic::codec {
namespace {

// ALGORITHM_FWP_CH for "fwp-ch".
v1::Algorithm AlgorithmNamed(std::string_view algorithm) {
  std::string name = "ALGORITHM_" + std::string(algorithm);
  absl::AsciiStrToUpper(&name);
  std::ranges::replace(name, '-', '_');
  v1::Algorithm result = v1::ALGORITHM_UNSPECIFIED;
  v1::Algorithm_Parse(name, &result);
  return result;
}

// Refuses parameters that are not the one which `algorithm` takes.
absl::Status CheckParameters(const v1::Approximation& given,
                             MethodParameter taken,
                             std::string_view algorithm) {
  const auto check = [&](bool is_given, MethodParameter parameter,
                         const char* name) {
    if (!is_given || parameter == taken) return absl::OkStatus();
    const std::string field = absl::StrCat("approximation.", name);
    return InvalidField(field,
                        absl::StrCat(field, " is no parameter of ",
                                     std::string(algorithm), "; leave it out"));
  };
  absl::Status status =
      check(given.has_lambda(), MethodParameter::kLambda, "lambda");
  status.Update(check(given.has_neighbours(), MethodParameter::kNeighbours,
                      "neighbours"));
  status.Update(
      check(given.has_samples(), MethodParameter::kSamples, "samples"));
  return status;
}

}  // namespace

v1::Algorithm ToProto(Algorithm algorithm) {
  return AlgorithmNamed(AlgorithmName(algorithm));
}

v1::Algorithm ToProto(ApproximateMethod method) {
  return AlgorithmNamed(ApproximateMethodName(method));
}

v1::Algorithm ToProto(const AlgorithmChoice& choice) {
  const auto* method = std::get_if<MethodChoice>(&choice);
  return method != nullptr ? ToProto(method->method)
                           : ToProto(std::get<Algorithm>(choice));
}

v1::Approximation ToProto(const MethodChoice& choice) {
  v1::Approximation proto;
  switch (InfoOf(choice.method).parameter) {
    case MethodParameter::kLambda:
      proto.set_lambda(choice.lambda);
      break;
    case MethodParameter::kNeighbours:
      proto.set_neighbours(choice.neighbours);
      break;
    case MethodParameter::kSamples:
      proto.set_samples(choice.samples);
      break;
    case MethodParameter::kNone:
      break;
  }
  return proto;
}

std::optional<AlgorithmChoice> FromProto(v1::Algorithm algorithm) {
  for (const ApproximateMethodInfo& info : kApproximateMethods) {
    if (ToProto(info.method) == algorithm) {
      return MethodChoice{.method = info.method};
    }
  }
  for (const AlgorithmInfo& info : kAlgorithms) {
    if (ToProto(info.algorithm) == algorithm) return info.algorithm;
  }
  return std::nullopt;
}

absl::StatusOr<AlgorithmChoice> FromProto(
    v1::Algorithm algorithm, const v1::Approximation& approximation) {
  std::optional<AlgorithmChoice> choice = algorithm == v1::ALGORITHM_UNSPECIFIED
                                              ? kDefaultAlgorithm
                                              : FromProto(algorithm);
  if (!choice.has_value()) {
    return InvalidField(
        "algorithm", absl::StrCat("algorithm is ", static_cast<int>(algorithm),
                                  ", which this server does not know; "
                                  "GetCapabilities lists those it does"));
  }
  auto* const method = std::get_if<MethodChoice>(&*choice);
  absl::Status status =
      method == nullptr
          ? CheckParameters(approximation, MethodParameter::kNone,
                            "an exact algorithm")
          : CheckParameters(approximation, InfoOf(method->method).parameter,
                            ApproximateMethodName(method->method));
  if (!status.ok()) return status;
  if (method != nullptr) {
    if (approximation.has_lambda()) method->lambda = approximation.lambda();
    if (approximation.has_neighbours()) {
      method->neighbours = approximation.neighbours();
    }
    if (approximation.has_samples()) method->samples = approximation.samples();
  }
  return *choice;
}

}  // namespace geodesic::codec
