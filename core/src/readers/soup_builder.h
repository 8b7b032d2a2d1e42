// Collects vertices and polygons into a TriangleSoup within limits.

#ifndef GEODESIC_READERS_SOUP_BUILDER_H_
#define GEODESIC_READERS_SOUP_BUILDER_H_

#include <cstdint>
#include <utility>

#include "absl/status/status.h"
#include "geodesic/read_mesh.h"
#include "geodesic/triangle_soup.h"

namespace geodesic {

// Polygons arrive corner by corner, so that no polygon is ever held beside its
// triangles, however many corners it claims.
//
// Errors of all calls: RESOURCE_EXHAUSTED naming the limit that is passed; what
// the limits' checkpoint says.
class SoupBuilder {
 public:
  explicit SoupBuilder(const ReadLimits& limits);

  // Makes room. REQUIRES: that many vertices or triangles fit the bytes that
  // are left to read; a header's word alone is not enough.
  absl::Status ReserveVertices(uint64_t count);
  absl::Status ReserveTriangles(uint64_t count);

  absl::Status AddVertex(const Point& point) {
    if (soup_.positions.size() >= next_vertices_) {
      if (absl::Status status = PauseAtVertex(); !status.ok()) return status;
    }
    soup_.positions.push_back(point);
    return absl::OkStatus();
  }

  // Starts a polygon; its corners follow. One with fewer than three corners
  // adds no triangle: that is for the caller to refuse.
  void BeginFace() { corners_ = 0; }
  absl::Status AddCorner(uint32_t vertex) {
    if (corners_ >= 2) {
      if (soup_.triangles.size() >= next_triangles_) {
        if (absl::Status status = PauseAtTriangle(); !status.ok()) {
          return status;
        }
      }
      soup_.triangles.push_back({first_, previous_, vertex});
    } else if (corners_ == 0) {
      first_ = vertex;
    }
    previous_ = vertex;
    ++corners_;
    return absl::OkStatus();
  }

  uint64_t vertices() const { return soup_.positions.size(); }

  TriangleSoup Take() && { return std::move(soup_); }

 private:
  // Ask whether to go on.
  absl::Status PauseAtVertex();
  absl::Status PauseAtTriangle();
  absl::Status TooManyVertices() const;
  absl::Status TooManyTriangles() const;

  const uint64_t max_vertices_;
  const uint64_t max_triangles_;
  Checkpoint* const checkpoint_;
  // How many there may be before the next pause; not above the limits.
  uint64_t next_vertices_ = 0;
  uint64_t next_triangles_ = 0;
  TriangleSoup soup_;
  // Of the polygon at hand.
  uint64_t corners_ = 0;
  uint32_t first_ = 0;
  uint32_t previous_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_READERS_SOUP_BUILDER_H_
