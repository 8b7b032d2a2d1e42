// Error messages of the mesh readers.

#ifndef GEODESIC_READERS_MESSAGES_H_
#define GEODESIC_READERS_MESSAGES_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace geodesic {

// `text` fit for a message: control and non-ASCII bytes escaped, shortened.
std::string Printable(std::string_view text, size_t max_bytes = 40);

// INVALID_ARGUMENT "line N: ..." for text files; lines count from 1.
template <typename... Parts>
absl::Status AtLine(uint64_t line, const Parts&... parts) {
  return absl::InvalidArgumentError(
      absl::StrCat("line ", line, ": ", parts...));
}

// INVALID_ARGUMENT "byte N: ..." for binary files; bytes count from 0.
template <typename... Parts>
absl::Status AtByte(uint64_t offset, const Parts&... parts) {
  return absl::InvalidArgumentError(
      absl::StrCat("byte ", offset, ": ", parts...));
}

}  // namespace geodesic

#endif  // GEODESIC_READERS_MESSAGES_H_
