// Ways into one face, in its plane: which parts of its perimeter hang together
// inside of it.

#ifndef GEODESIC_QUESTIONS_ISOLINES_FACE_WAYS_H_
#define GEODESIC_QUESTIONS_ISOLINES_FACE_WAYS_H_

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geodesic/mesh.h"
#include "questions/isolines/face_regions.h"
#include "questions/isolines/way.h"
#include "surface/surface_location.h"

namespace geodesic {

// What each way covers of the face below a level is convex: a disc (of a curve,
// a half-plane), cut by its rays' cone (or strip) and by the face. So it joins
// whatever it touches of the perimeter. Two such parts that do not meet on the
// perimeter first meet, as the level grows, on a line that runs along rays of
// both: elsewhere inside the face distance has no saddle.
class FaceWays {
 public:
  FaceWays(const Mesh& mesh, uint32_t face);

  // A way into the face through its half-edge h.
  void AddThrough(HalfEdge h, const Way& way);
  // Straight from a point of the face, in the frame of its first half-edge.
  void AddWithin(const PlanePoint& from, double sigma);
  // From a segment of a curve in the face.
  void AddWithin(const CurveSegment& segment, double sigma);

  // Joins the regions that hang together below `level`.
  void JoinRegions(double level, FaceRegions& regions) const;

 private:
  static constexpr uint32_t kWithin = 3;

  struct FaceWay {
    // In the plane of the face: the unfolded pseudo-source; or of a segment
    // whose rays enter the face, the unit vector in which they run.
    PlanePoint from;
    bool is_segment = false;
    double sigma = 0;  // of a segment: the distance that its rays give (0, 0)
    uint32_t entry = kWithin;  // side through which it enters, or kWithin
    // On each side, along it; an empty interval where the way does not lead.
    std::array<Way, 3> on_side = {};
  };

  bool Sees(const FaceWay& way, const PlanePoint& point) const;
  // Where two ways of the same length run against each other; none if nowhere,
  // and not looked for between segments, whose strips end in points' discs.
  std::optional<PlanePoint> MeetingPoint(const FaceWay& a,
                                         const FaceWay& b) const;
  bool Meet(const FaceWay& a, const FaceWay& b, double level) const;
  PlanePoint InFrameOfSide(uint32_t side, const PlanePoint& point) const;
  PlanePoint FromFrameOfSide(uint32_t side, const PlanePoint& point) const;

  const Mesh& mesh_;
  const HalfEdge first_;
  std::array<PlanePoint, 3> corners_;
  std::array<PlanePoint, 3> directions_;  // of the sides, unit vectors
  std::vector<FaceWay> ways_;
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_FACE_WAYS_H_
