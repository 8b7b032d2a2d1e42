#include "readers/soup_builder.h"

#include <algorithm>
#include <limits>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace geodesic {
namespace {

// Whatever the caller's limits, an index must fit 32 bits.
constexpr uint64_t kMost = std::numeric_limits<uint32_t>::max();

}  // namespace

SoupBuilder::SoupBuilder(const ReadLimits& limits)
    : max_vertices_(std::min(limits.max_vertices, kMost)),
      max_triangles_(std::min(limits.max_triangles, kMost)) {}

absl::Status SoupBuilder::ReserveVertices(uint64_t count) {
  if (count > max_vertices_) return TooManyVertices();
  soup_.positions.reserve(count);
  return absl::OkStatus();
}

absl::Status SoupBuilder::ReserveTriangles(uint64_t count) {
  if (count > max_triangles_) return TooManyTriangles();
  soup_.triangles.reserve(count);
  return absl::OkStatus();
}

absl::Status SoupBuilder::TooManyVertices() const {
  return absl::ResourceExhaustedError(
      absl::StrCat("the file has more vertices than the limit of ",
                   max_vertices_, " (max_vertices)"));
}

absl::Status SoupBuilder::TooManyTriangles() const {
  return absl::ResourceExhaustedError(
      absl::StrCat("the file has more triangles than the limit of ",
                   max_triangles_, " (max_triangles)"));
}

}  // namespace geodesic
