// A status can carry, beside its message, the path of the part of a question
// that the error is about.
//
// A path names the parts as the protocol's messages do (proto/), e.g.
// "sources[1].face.weights[0]", "targets[2].edge.t" or "algorithm".

#ifndef GEODESIC_TYPES_FIELD_PATH_H_
#define GEODESIC_TYPES_FIELD_PATH_H_

#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/strings/cord.h"
#include "absl/strings/string_view.h"

namespace geodesic {

// Names the path among a status's payloads.
inline constexpr char kFieldPathUrl[] = "geodesic/field-path";

// The status with that path, which replaces any that it has. OK stays OK.
inline absl::Status WithFieldPath(absl::Status status, std::string_view path) {
  status.SetPayload(kFieldPathUrl, absl::Cord(std::string(path)));
  return status;
}

// INVALID_ARGUMENT with that path. The message stands alone, so it names the
// path, too.
inline absl::Status InvalidField(std::string_view path,
                                 std::string_view message) {
  // Abseil's own type of view where it was built for C++14.
  return WithFieldPath(absl::InvalidArgumentError(
                           absl::string_view(message.data(), message.size())),
                       path);
}

// Nothing where the status names no part.
inline std::optional<std::string> FieldPathOf(const absl::Status& status) {
  const auto payload = status.GetPayload(kFieldPathUrl);
  if (!payload) return std::nullopt;
  return std::string(*payload);
}

}  // namespace geodesic

#endif  // GEODESIC_TYPES_FIELD_PATH_H_
