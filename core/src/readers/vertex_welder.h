// Gives indices to vertices that a file repeats instead of numbering.

#ifndef GEODESIC_READERS_VERTEX_WELDER_H_
#define GEODESIC_READERS_VERTEX_WELDER_H_

#include <cstdint>

#include "absl/container/flat_hash_map.h"
#include "absl/status/status.h"
#include "geodesic/triangle_soup.h"
#include "readers/soup_builder.h"

namespace geodesic {

class VertexWelder {
 public:
  explicit VertexWelder(SoupBuilder& builder) : builder_(builder) {}

  // Adds a corner to the face at hand: the vertex at `point`, made when no
  // vertex has equal coordinates (-0 equals 0) yet. REQUIRES: finite. Errors:
  // as SoupBuilder.
  absl::Status AddCorner(const Point& point) {
    const auto [entry, is_new] =
        indices_.try_emplace(point, static_cast<uint32_t>(builder_.vertices()));
    if (is_new) {
      if (absl::Status status = builder_.AddVertex(point); !status.ok()) {
        return status;
      }
    }
    return builder_.AddCorner(entry->second);
  }

 private:
  SoupBuilder& builder_;
  // Its hash is seeded, so no file can be made to collide.
  absl::flat_hash_map<Point, uint32_t> indices_;
};

}  // namespace geodesic

#endif  // GEODESIC_READERS_VERTEX_WELDER_H_
