// The sources that are no vertices, as seen from the faces that they lie in.

#ifndef GEODESIC_QUESTIONS_ISOLINES_FACE_SOURCES_H_
#define GEODESIC_QUESTIONS_ISOLINES_FACE_SOURCES_H_

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "geodesic/mesh.h"
#include "solver/curve_segment.h"
#include "surface/anchors.h"

namespace geodesic {

// Points and segments of curves. One that lies on an edge is kept once, however
// many faces share the edge. Lengths are in the mesh's scaled unit.
class FaceSources {
 public:
  // Both outlive this object.
  FaceSources(const Mesh& mesh, std::span<const Anchor> anchors);

  // What starts in one face or on its sides, and its distance there.
  struct Within {
    std::vector<std::pair<FacePoint, double>> points;
    std::vector<std::pair<CurveSegment, double>> segments;
  };
  // In the order of anchors. O(those in the face, times the logarithm of their
  // number).
  Within In(uint32_t face) const;
  bool HasAny(uint32_t face) const;

 private:
  using Numbers = std::vector<uint32_t>;

  // Of an anchor that lies on an edge, with its ends.
  void AddOnEdge(uint32_t number, uint32_t from, uint32_t to);

  const Mesh& mesh_;
  const std::span<const Anchor> anchors_;
  // The numbers of anchors that lie inside of a face; on an edge, by its lowest
  // half-edge.
  absl::flat_hash_map<uint32_t, Numbers> in_faces_;
  absl::flat_hash_map<HalfEdge, Numbers> on_edges_;
  // The lowest half-edges of all edges between two vertices.
  absl::flat_hash_map<std::pair<uint32_t, uint32_t>, std::vector<HalfEdge>>
      edges_between_;
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_FACE_SOURCES_H_
