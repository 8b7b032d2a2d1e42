// All directions between two.

#ifndef GEODESIC_QUESTIONS_ISOLINES_DIRECTION_CONE_H_
#define GEODESIC_QUESTIONS_ISOLINES_DIRECTION_CONE_H_

#include "surface/plane_point.h"

namespace geodesic {

// The least cone that holds some directions, while that is less than a half
// turn.
class DirectionCone {
 public:
  // Adds a direction, of any length above 0; whether that leaves it a cone.
  bool Add(const PlanePoint& direction);

  // How far a curve may lie from its chord if it runs so that it has one of
  // these directions on its right everywhere: its tangents are those of the
  // cone turned left. Infinite if the chord does not, or the cone is empty.
  double FarthestFrom(const PlanePoint& chord) const;

 private:
  bool is_empty_ = true;
  PlanePoint right_, left_;  // unit vectors
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_DIRECTION_CONE_H_
