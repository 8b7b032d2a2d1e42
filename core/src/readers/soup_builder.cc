#include "readers/soup_builder.h"

#include <algorithm>
#include <limits>

#include "absl/strings/str_cat.h"
#include "geodesic/checkpoint.h"
#include "mesh/large_pages.h"
#include "polygons/cut_polygons.h"

namespace geodesic {
namespace {

// Whatever the caller's limits, an index must fit 32 bits.
constexpr uint64_t kMost = std::numeric_limits<uint32_t>::max();

// Some 10 ms of text.
constexpr uint64_t kBetweenPauses = uint64_t{1} << 16;

}  // namespace

SoupBuilder::SoupBuilder(const ReadLimits& limits)
    : vertices_{"vertices", std::min(limits.max_vertices, kMost)},
      triangles_{"triangles", std::min(limits.max_triangles, kMost)},
      checkpoint_(limits.checkpoint) {}

bool SoupBuilder::ReserveVertices(uint64_t count) {
  if (count > vertices_.most) return RefuseMore(vertices_);
  ReserveLarge(count, soup_.positions);
  return true;
}

bool SoupBuilder::ReserveTriangles(uint64_t count) {
  if (count > triangles_.most) return RefuseMore(triangles_);
  ReserveLarge(count, soup_.triangles);
  return true;
}

absl::StatusOr<TriangleSoup> SoupBuilder::Take() && {
  if (!error_.ok()) return std::move(error_);
  if (absl::Status s = CutPolygons(is_joined_, checkpoint_, soup_); !s.ok()) {
    return s;
  }
  return std::move(soup_);
}

bool SoupBuilder::Poll() {
  if (checkpoint_ == nullptr) return true;
  const absl::Status status = checkpoint_->Poll({});
  return status.ok() || Refuse(status);
}

bool SoupBuilder::Pause(uint64_t count, Limit& limit) {
  if (count >= limit.most) return RefuseMore(limit);
  limit.next = limit.most;
  if (checkpoint_ == nullptr) return true;
  limit.next = std::min(limit.most, count + kBetweenPauses);
  return Poll();
}

bool SoupBuilder::RefuseMore(const Limit& limit) {
  return Refuse(absl::ResourceExhaustedError(
      absl::StrCat("the file has more ", limit.things, " than the limit of ",
                   limit.most, " (max_", limit.things, ")")));
}

}  // namespace geodesic
