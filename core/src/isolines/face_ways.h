// Ways into one face, in its plane: which parts of its perimeter hang together
// inside of it.

#ifndef GEODESIC_ISOLINES_FACE_WAYS_H_
#define GEODESIC_ISOLINES_FACE_WAYS_H_

#include <array>
#include <cstdint>
#include <vector>

#include "geodesic/mesh.h"
#include "isolines/face_regions.h"
#include "isolines/way.h"
#include "surface_location.h"

namespace geodesic {

// What each way covers of the face below a level is convex: a disc, cut by the
// cone of its rays and by the face. So it joins whatever it touches of the
// perimeter. Two such parts that do not meet on the perimeter first meet, as
// the level grows, on the line between their pseudo-sources: elsewhere inside
// the face distance has no saddle.
class FaceWays {
 public:
  FaceWays(const Mesh& mesh, uint32_t face);

  // A way into the face through its half-edge h.
  void AddThrough(HalfEdge h, const Way& way);
  // Straight from a point of the face, in the frame of its first half-edge.
  void AddWithin(const PlanePoint& from, double sigma);

  // Joins the regions that hang together below `level`.
  void JoinRegions(double level, FaceRegions& regions) const;

 private:
  static constexpr uint32_t kWithin = 3;

  struct FaceWay {
    PlanePoint from;  // unfolded pseudo-source
    double sigma;
    uint32_t entry;  // side through which it enters, or kWithin
    // On each side, along it; an empty interval where the way does not lead.
    std::array<Way, 3> on_side;
  };

  bool Sees(const FaceWay& way, const PlanePoint& point) const;
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

#endif  // GEODESIC_ISOLINES_FACE_WAYS_H_
