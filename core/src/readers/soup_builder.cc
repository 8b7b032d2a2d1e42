#include "readers/soup_builder.h"

#include <algorithm>
#include <limits>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "geodesic/checkpoint.h"

namespace geodesic {
namespace {

// Whatever the caller's limits, an index must fit 32 bits.
constexpr uint64_t kMost = std::numeric_limits<uint32_t>::max();

// Some 10 ms of text.
constexpr uint64_t kBetweenPauses = uint64_t{1} << 16;

// Where there are `count` of at most `most`: how many there may be before the
// next pause.
absl::StatusOr<uint64_t> Pause(uint64_t count, uint64_t most,
                               Checkpoint* checkpoint) {
  if (checkpoint == nullptr) return most;
  if (absl::Status status = checkpoint->Poll({}); !status.ok()) return status;
  return std::min(most, count + kBetweenPauses);
}

}  // namespace

SoupBuilder::SoupBuilder(const ReadLimits& limits)
    : max_vertices_(std::min(limits.max_vertices, kMost)),
      max_triangles_(std::min(limits.max_triangles, kMost)),
      checkpoint_(limits.checkpoint) {}

absl::Status SoupBuilder::PauseAtVertex() {
  if (soup_.positions.size() >= max_vertices_) return TooManyVertices();
  const absl::StatusOr<uint64_t> next =
      Pause(soup_.positions.size(), max_vertices_, checkpoint_);
  if (next.ok()) next_vertices_ = *next;
  return next.status();
}

absl::Status SoupBuilder::PauseAtTriangle() {
  if (soup_.triangles.size() >= max_triangles_) return TooManyTriangles();
  const absl::StatusOr<uint64_t> next =
      Pause(soup_.triangles.size(), max_triangles_, checkpoint_);
  if (next.ok()) next_triangles_ = *next;
  return next.status();
}

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
