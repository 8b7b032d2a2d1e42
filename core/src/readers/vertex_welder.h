// Gives indices to vertices that a file repeats instead of numbering.

#ifndef GEODESIC_READERS_VERTEX_WELDER_H_
#define GEODESIC_READERS_VERTEX_WELDER_H_

#include <cstdint>
#include <optional>

#include "absl/container/flat_hash_map.h"
#include "geodesic/triangle_soup.h"
#include "readers/soup_builder.h"

namespace geodesic {

class VertexWelder {
 public:
  explicit VertexWelder(SoupBuilder& builder) : builder_(builder) {}

  // The vertex at `point`, made when no vertex has equal coordinates (-0 equals
  // 0) yet; empty if the builder refuses it. REQUIRES: finite.
  std::optional<uint32_t> Vertex(const Point& point) {
    const auto [entry, is_new] =
        indices_.try_emplace(point, static_cast<uint32_t>(builder_.vertices()));
    if (is_new && !builder_.AddVertex(point)) return std::nullopt;
    return entry->second;
  }

  // Adds the vertex as a corner to the face at hand. Whether to go on.
  bool AddCorner(const Point& point) {
    const std::optional<uint32_t> vertex = Vertex(point);
    return vertex.has_value() && builder_.AddCorner(*vertex);
  }

 private:
  SoupBuilder& builder_;
  // Its hash is seeded, so no file can be made to collide.
  absl::flat_hash_map<Point, uint32_t> indices_;
};

}  // namespace geodesic

#endif  // GEODESIC_READERS_VERTEX_WELDER_H_
