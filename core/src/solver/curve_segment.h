// A straight segment of a curve source, in the plane of a face.

#ifndef GEODESIC_SOLVER_CURVE_SEGMENT_H_
#define GEODESIC_SOLVER_CURVE_SEGMENT_H_

#include <optional>
#include <vector>

#include "geodesic/mesh.h"
#include "solver/windows/mixed_origin.h"
#include "surface/anchors.h"
#include "surface/plane_point.h"

namespace geodesic {

// Shortest paths leave it at right angles: within its face they fill a strip on
// either side.
class CurveSegment {
 public:
  CurveSegment(const Mesh& mesh, const FacePoint& begin, const FacePoint& end);

  uint32_t face() const { return begin_.face; }
  const FacePoint& begin() const { return begin_; }
  const FacePoint& end() const { return end_; }

  // Distance to a place in the frame of the face's first half-edge, if that
  // lies in the strip; +infinity if not.
  double DistanceTo(const PlanePoint& place) const;

  // The part of the strip that leaves the face across side h.
  struct Beam {
    MixedOrigin origin;  // sigma: without the offset
    Interval interval;
  };
  // In the frame of an oriented neighbour; nothing if no ray goes there, or if
  // the segment lies on that side, whose other faces hold it too.
  std::optional<Beam> BeamAcross(HalfEdge h) const;

 private:
  const Mesh& mesh_;
  FacePoint begin_, end_;
};

// The segment in every face that holds both its ends: one, unless it runs along
// an edge or a face is given twice.
std::vector<CurveSegment> SegmentsOf(const Mesh& mesh, const Anchor& anchor);

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_CURVE_SEGMENT_H_
