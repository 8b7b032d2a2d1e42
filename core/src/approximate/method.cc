#include "geodesic/approximate/method.h"

#include <string>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"

namespace geodesic {

absl::StatusOr<ApproximateMethod> ApproximateMethodFromName(
    std::string_view name) {
  for (const ApproximateMethodInfo& info : kApproximateMethods) {
    if (info.name == name) return info.method;
  }
  const std::string known =
      absl::StrJoin(kApproximateMethods, ", ",
                    [](std::string* out, const ApproximateMethodInfo& info) {
                      out->append(info.name);
                    });
  return absl::InvalidArgumentError(
      absl::StrCat("unknown approximate method \"", std::string(name),
                   "\"; known are: ", known));
}

}  // namespace geodesic
