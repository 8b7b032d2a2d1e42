#include "geodesic/mesh_arrays.h"

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace geodesic::mesh_arrays {

absl::Status CheckColumns(const char* what, size_t columns) {
  if (columns == 3) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(
      "the ", what, " have ", columns, " columns; three are needed"));
}

absl::Status CheckLength(const char* what, size_t length) {
  if (length % 3 == 0) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(
      "the ", what, " are ", length, " numbers, which three does not divide"));
}

absl::Status BadCorner(size_t face, size_t corner, int64_t vertex) {
  return absl::InvalidArgumentError(
      absl::StrCat("face ", face, ": corner ", corner, " is ", vertex,
                   "; vertices are numbered from 0, below 2^32"));
}

}  // namespace geodesic::mesh_arrays
