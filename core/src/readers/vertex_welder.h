// Gives numbers to the vertices of a file that has none.

#ifndef GEODESIC_READERS_VERTEX_WELDER_H_
#define GEODESIC_READERS_VERTEX_WELDER_H_

#include <cstdint>

#include "absl/container/flat_hash_map.h"
#include "geodesic/triangle_soup.h"
#include "readers/soup_builder.h"

namespace geodesic {

class VertexWelder {
 public:
  // `welds`: equal coordinates (-0 equals 0) have one number. Otherwise each
  // corner has its own.
  VertexWelder(SoupBuilder& builder, bool welds)
      : builder_(builder), welds_(welds) {}

  // Adds the vertex at `point`, in order of first appearance, as a corner to
  // the face at hand. Whether to go on. REQUIRES: finite.
  bool AddCorner(const Point& point) {
    const auto next = static_cast<uint32_t>(builder_.vertices());
    const uint32_t vertex =
        welds_ ? indices_.try_emplace(point, next).first->second : next;
    return (vertex != next || builder_.AddVertex(point)) &&
           builder_.AddCorner(vertex);
  }

 private:
  SoupBuilder& builder_;
  const bool welds_;
  // Its hash is seeded, so no file can be made to collide.
  absl::flat_hash_map<Point, uint32_t> indices_;
};

}  // namespace geodesic

#endif  // GEODESIC_READERS_VERTEX_WELDER_H_
