#include "questions/isolines/direction_cone.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tolerances.h"

namespace geodesic {

bool DirectionCone::Add(const PlanePoint& direction) {
  const double length = Norm(direction);
  const PlanePoint unit = {direction.x / length, direction.y / length};
  if (is_empty_) {
    is_empty_ = false;
    right_ = left_ = unit;
    return true;
  }
  const bool is_left_of_right = Cross(right_, unit) >= 0;
  const bool is_right_of_left = Cross(unit, left_) >= 0;
  if (is_left_of_right && is_right_of_left) {
    // Between them, or opposite to both while they are one.
    return Dot(right_, unit) > 0 || Dot(left_, unit) > 0 ||
           Cross(right_, left_) > 0;
  }
  if (!is_left_of_right && !is_right_of_left) return false;
  (is_left_of_right ? left_ : right_) = unit;
  return Dot(right_, left_) > 0 || Cross(right_, left_) > kSameRay;
}

double DirectionCone::FarthestFrom(const PlanePoint& chord) const {
  const double length = Norm(chord);
  if (is_empty_ || !(length > 0))
    return std::numeric_limits<double>::infinity();
  const PlanePoint out = {chord.y / length, -chord.x / length};
  const double right_sine = Cross(right_, out), left_sine = Cross(out, left_);
  if (right_sine < -kSameRay || left_sine < -kSameRay) {
    return std::numeric_limits<double>::infinity();
  }
  if (right_sine <= 0 || left_sine <= 0) return length * kSameRay;
  // The tip of the triangle that the two outermost tangents make with it;
  // beyond an end of the chord where the angle there is blunt.
  const double at_right = Dot(right_, out) / right_sine;
  const double at_left = Dot(out, left_) / left_sine;
  const double height = length / (at_right + at_left);
  return height * std::hypot(1, std::min({at_right, at_left, 0.0}));
}

}  // namespace geodesic
