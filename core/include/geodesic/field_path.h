// A status can carry, beside its message, the path of the part of a question
// that the error is about.
//
// A path names the parts as the protocol's messages do (proto/), e.g.
// "sources[1].face.weights[0]", "targets[2].edge.t" or "algorithm".

#ifndef GEODESIC_FIELD_PATH_H_
#define GEODESIC_FIELD_PATH_H_

#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace geodesic {

// The status with that path, which replaces any that it has. OK stays OK.
absl::Status WithFieldPath(absl::Status status, std::string_view path);

// INVALID_ARGUMENT with that path. The message stands alone, so it names the
// path, too.
absl::Status InvalidField(std::string_view path, std::string_view message);

// Nothing where the status names no part.
std::optional<std::string> FieldPathOf(const absl::Status& status);

}  // namespace geodesic

#endif  // GEODESIC_FIELD_PATH_H_
