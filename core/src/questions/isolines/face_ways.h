// Ways into one face, in its plane: distance inside of it is the least of
// theirs.

#ifndef GEODESIC_QUESTIONS_ISOLINES_FACE_WAYS_H_
#define GEODESIC_QUESTIONS_ISOLINES_FACE_WAYS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "questions/isolines/direction_cone.h"
#include "questions/isolines/way.h"
#include "surface/plane_point.h"

namespace geodesic {

// The side of a straight line on which Dot(normal, p) >= offset.
struct HalfPlane {
  PlanePoint normal;  // a unit vector
  double offset = 0;

  // How far inside a place lies.
  double Depth(const PlanePoint& place) const {
    return Dot(normal, place) - offset;
  }
};

// The half-plane to the left of a line through `place`. `along`: its direction,
// of any length above 0.
HalfPlane LeftOf(const PlanePoint& place, const PlanePoint& along);

// The straight ways from one pseudo-source, or from a segment, to what lies
// within its bounds.
struct FaceWay {
  // The unfolded pseudo-source; or of a segment the unit vector in which its
  // rays run.
  PlanePoint from;
  bool is_segment = false;
  double sigma = 0;  // of a segment: the distance that its rays give (0, 0)
  // Bounds on what is reached in the face.
  double label = 0;
  double farthest = 0;
  std::array<HalfPlane, 3> bounds = {};
  uint32_t bound_count = 0;

  std::span<const HalfPlane> Bounds() const {
    return std::span(bounds).first(bound_count);
  }
  void AddBound(const HalfPlane& bound) { bounds[bound_count++] = bound; }
  // Whether the ways lead to a place, which may be this far outside.
  bool LeadsTo(const PlanePoint& place, double outside) const;
  // Whether a front of this level runs through the face.
  bool MayHaveFront(double level) const {
    return IsNearer(label, level) && farthest > level;
  }
  // Whether or not they lead there.
  double DistanceTo(const PlanePoint& place) const;
};

// A window is followed by the discs around the ends of its interval: what it
// does not see is reached around these. So distance is continuous in the whole
// face, whatever gaps rounding leaves between windows, and each way's part of
// the face below a level is convex.
class FaceWays {
 public:
  // Told how much was done, in ways looked at. What it returns stops the work.
  using Step = std::function<absl::Status(uint64_t work)>;

  FaceWays(const Mesh& mesh, uint32_t face);

  // A way into the face through its half-edge h. `at_ends`: the distances of
  // the half-edge's ends.
  void AddThrough(HalfEdge h, const Way& way,
                  const std::array<double, 2>& at_ends);
  // Straight from a corner, unless its distance is infinite.
  void AddCorner(uint32_t corner, double sigma);
  // Straight from a source in the face: from a point, or from a segment of a
  // curve, whose ends are points of their own.
  void AddWithin(const FacePoint& point, double sigma);
  void AddWithin(const CurveSegment& segment, double sigma);

  const std::vector<FaceWay>& ways() const { return ways_; }
  // What lies no farther from a segment than this.
  struct Neighbourhood {
    PlanePoint begin;
    PlanePoint end;
    double distance = 0;
  };
  // In which directions distance grows along the isolines of a level, where
  // they run there; none if these are not known to lie within a half turn. If
  // they do, no isoline is closed in the face. Discs around places that windows
  // pass on both sides are not on the isolines.
  // Errors: whatever `step` returns.
  absl::StatusOr<std::optional<DirectionCone>> DirectionsAt(
      double level, const Neighbourhood& there, const Step& step);
  bool has_sources() const { return has_sources_; }
  const std::array<PlanePoint, 3>& corners() const { return corners_; }
  // What lies inside of each side.
  const std::array<HalfPlane, 3>& sides() const { return sides_; }
  // The longest side.
  double size() const { return size_; }
  // Over that.
  double height() const;
  // The place of the perimeter, as a side and the distance along it.
  PlanePoint OnSide(uint32_t side, double along) const;
  // The place, or where rounding has put it outside, one beside it; never on an
  // edge.
  FacePoint PointAt(const PlanePoint& place) const;

 private:
  PlanePoint FromFrameOfSide(uint32_t side, const PlanePoint& point) const;
  void AddPoint(const PlanePoint& from, double sigma);
  void Add(FaceWay way);
  // Whether other ways lead all around the source of a disc, no farther.
  bool IsCovered(const FaceWay& disc) const;
  // The same by its number among the ways, found once: called when all are
  // added.
  bool IsKnownToBeCovered(size_t disc);

  const Mesh& mesh_;
  const HalfEdge first_;
  std::array<PlanePoint, 3> corners_;
  std::array<PlanePoint, 3> directions_;  // of the sides, unit vectors
  std::array<HalfPlane, 3> sides_;
  double size_ = 0;
  bool has_sources_ = false;
  std::vector<FaceWay> ways_;
  std::vector<std::optional<bool>> covers_;
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_FACE_WAYS_H_
