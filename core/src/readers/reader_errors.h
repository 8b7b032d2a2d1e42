// Error messages of the mesh readers.

#ifndef GEODESIC_READERS_READER_ERRORS_H_
#define GEODESIC_READERS_READER_ERRORS_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/string_view.h"

namespace geodesic {

// `text` fit for a message: control and non-ASCII bytes escaped, shortened.
inline std::string Printable(std::string_view text, size_t max_bytes = 40) {
  const std::string_view head = text.substr(0, max_bytes);
  return absl::StrCat(
      absl::CHexEscape(absl::string_view(head.data(), head.size())),
      head.size() < text.size() ? "..." : "");
}

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

// What is wrong with a face, behind its name.
inline std::string TooFewCorners(int64_t corners) {
  return absl::StrCat(" has ", corners, " corners; at least 3 are needed");
}
inline std::string NamesNoVertex(int64_t vertex, uint64_t vertices) {
  return absl::StrCat(" names vertex ", vertex, ", but there are ", vertices,
                      " vertices, counted from 0");
}

}  // namespace geodesic

#endif  // GEODESIC_READERS_READER_ERRORS_H_
