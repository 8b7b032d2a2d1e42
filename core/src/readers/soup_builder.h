// Collects vertices and polygons into a TriangleSoup within limits.

#ifndef GEODESIC_READERS_SOUP_BUILDER_H_
#define GEODESIC_READERS_SOUP_BUILDER_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/read_mesh.h"
#include "geodesic/triangle_soup.h"

namespace geodesic {

// Polygons arrive corner by corner and are held as fans, so that none is ever
// held beside its triangles, however many corners it claims. At the end, when
// all vertices are known, they are cut.
//
// Calls return whether to go on. After the first false the file is refused, and
// Take says why.
class SoupBuilder {
 public:
  explicit SoupBuilder(const ReadLimits& limits);

  // Makes room. REQUIRES: that many vertices or triangles fit the bytes that
  // are left to read; a header's word alone is not enough.
  bool ReserveVertices(uint64_t count);
  bool ReserveTriangles(uint64_t count);

  bool AddVertex(const Point& point) {
    if (soup_.positions.size() >= vertices_.next &&
        !Pause(soup_.positions.size(), vertices_)) {
      return false;
    }
    soup_.positions.push_back(point);
    return true;
  }

  // Takes all vertices at once. REQUIRES: there are none yet, and no more than
  // the limit.
  void SetVertices(std::vector<Point> positions) {
    soup_.positions = std::move(positions);
  }

  // Starts a polygon; its corners follow. One with fewer than three corners
  // adds no triangle: that is for the caller to refuse.
  void BeginFace() { corners_ = 0; }
  bool AddCorner(uint32_t vertex) {
    if (corners_ >= 2) {
      if (corners_ > 2) Join();
      if (!AddTriangle({first_, previous_, vertex})) return false;
    } else if (corners_ == 0) {
      first_ = vertex;
    }
    previous_ = vertex;
    ++corners_;
    return true;
  }

  // A polygon of three corners at once.
  bool AddTriangle(const Triangle& corners) {
    if (soup_.triangles.size() >= triangles_.next &&
        !Pause(soup_.triangles.size(), triangles_)) {
      return false;
    }
    soup_.triangles.push_back(corners);
    return true;
  }

  // For work that adds nothing: asks the limits' checkpoint.
  bool Poll();

  // Refuses the file. Always false.
  bool Refuse(absl::Status error) {
    error_ = std::move(error);
    return false;
  }

  uint64_t vertices() const { return soup_.positions.size(); }

  // REQUIRES: corners name vertices, unless the file was refused. Errors: what
  // Refuse was given; RESOURCE_EXHAUSTED naming the limit that was passed; what
  // the limits' checkpoint said.
  absl::StatusOr<TriangleSoup> Take() &&;

 private:
  struct Limit {
    const char* things;
    uint64_t most;
    // How many there may be before the next pause; not above `most`.
    uint64_t next = 0;
  };

  // Asks whether more than `count` may be added.
  bool Pause(uint64_t count, Limit& limit);
  bool RefuseMore(const Limit& limit);
  // Says that the next triangle belongs to the polygon of the last.
  void Join() {
    is_joined_.resize(soup_.triangles.size());
    is_joined_.push_back(true);
  }

  Limit vertices_;
  Limit triangles_;
  Checkpoint* const checkpoint_;
  absl::Status error_;
  TriangleSoup soup_;
  // See CutPolygons.
  std::vector<bool> is_joined_;
  // Of the polygon at hand.
  uint64_t corners_ = 0;
  uint32_t first_ = 0;
  uint32_t previous_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_READERS_SOUP_BUILDER_H_
