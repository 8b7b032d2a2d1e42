#include "geodesic/polygons.h"

#include <utility>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic/read_mesh.h"
#include "readers/reader_errors.h"
#include "readers/soup_builder.h"

namespace geodesic {
namespace {

template <typename... Parts>
absl::Status Refusal(size_t polygon, const Parts&... parts) {
  return absl::InvalidArgumentError(absl::StrCat("face ", polygon, parts...));
}

}  // namespace

absl::StatusOr<TriangleSoup> TriangulatePolygons(
    std::vector<Point> positions, std::span<const int64_t> corners,
    std::span<const int64_t> sizes, Checkpoint* checkpoint) {
  SoupBuilder builder({.checkpoint = checkpoint});
  const uint64_t vertices = positions.size();
  builder.SetVertices(std::move(positions));
  for (size_t polygon = 0; polygon < sizes.size(); ++polygon) {
    const int64_t size = sizes[polygon];
    if (size < 3) return Refusal(polygon, TooFewCorners(size));
    if (static_cast<uint64_t>(size) > corners.size()) {
      return Refusal(polygon, " has ", size, " corners, but ", corners.size(),
                     " are left");
    }
    builder.BeginFace();
    for (const int64_t vertex : corners.first(size)) {
      if (vertex < 0 || static_cast<uint64_t>(vertex) >= vertices) {
        return Refusal(polygon, NamesNoVertex(vertex, vertices));
      }
      if (!builder.AddCorner(static_cast<uint32_t>(vertex))) {
        return std::move(builder).Take();
      }
    }
    corners = corners.subspan(size);
  }
  return std::move(builder).Take();
}

}  // namespace geodesic
