// A face laid into the plane, once from each of its sides.

#ifndef GEODESIC_MESH_FACE_LAYOUT_H_
#define GEODESIC_MESH_FACE_LAYOUT_H_

#include <algorithm>
#include <array>

#include "geodesic/mesh.h"
#include "mesh/scaled_difference.h"
#include "tolerances.h"

namespace geodesic {

// The frames of the face's sides, the first of which runs from the first corner
// to the second, but for where they lead.
inline std::array<HalfEdgeFrame, 3> LayOutFace(
    const std::array<const Point*, 3>& corners,
    const ScaledDifference& difference) {
  std::array<HalfEdgeFrame, 3> frames;
  const std::array<Vector, 3> sides = {difference(*corners[0], *corners[1]),
                                       difference(*corners[1], *corners[2]),
                                       difference(*corners[2], *corners[0])};
  const std::array<double, 3> lengths = {Norm(sides[0]), Norm(sides[1]),
                                         Norm(sides[2])};
  // From side i to the next.
  const std::array<double, 3> dots = {Dot(sides[0], sides[1]),
                                      Dot(sides[1], sides[2]),
                                      Dot(sides[2], sides[0])};
  // Coordinates rather than the three lengths: a cap's height is far below one
  // rounding of its lengths. And from the two shorter sides: the product of
  // long ones cancels in a needle. Compared without a branch, for which side is
  // longest cannot be foreseen.
  int longest = lengths[1] > lengths[0] ? 1 : 0;
  longest = lengths[2] > lengths[longest] ? 2 : longest;
  const double twice_area =
      Norm(Cross(sides[(longest + 1) % 3], sides[(longest + 2) % 3]));
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3, previous = (i + 2) % 3;
    const double length = lengths[i], left = lengths[previous],
                 right = lengths[next];
    HalfEdgeFrame& frame = frames[i];
    frame.length = length;
    if (length > 0) {
      frame.apex_x = -dots[previous] / length;
      frame.apex_y = std::max(twice_area / length, kLeastHeight);
    } else {
      frame.apex_x = 0;
      frame.apex_y = std::max(left, kLeastHeight);
    }
    // Each direction from its own side's coordinates: apex_x - length cancels
    // where the side is short. A side without length carries no window, and
    // any unit vector will do.
    frame.left_x = left > 0 ? frame.apex_x / left : 0;
    frame.left_y = left > 0 ? frame.apex_y / left : 1;
    frame.right_x = right > 0 && length > 0 ? dots[i] / length / right : -1;
    frame.right_y = right > 0 && length > 0 ? frame.apex_y / right : 0;
  }
  return frames;
}

}  // namespace geodesic

#endif  // GEODESIC_MESH_FACE_LAYOUT_H_
