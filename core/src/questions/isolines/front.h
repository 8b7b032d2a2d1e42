// Where one way into a face is as long as a level: an arc of a circle, or a
// straight line.

#ifndef GEODESIC_QUESTIONS_ISOLINES_FRONT_H_
#define GEODESIC_QUESTIONS_ISOLINES_FRONT_H_

#include <limits>
#include <numbers>
#include <vector>

#include "questions/isolines/face_ways.h"
#include "solver/windows/window.h"
#include "surface/plane_point.h"

namespace geodesic {

// Runs such that what is nearer is on its left: around the pseudo-source
// anticlockwise. Its parameter is the angle there; of a straight line the
// distance along it.
class Front {
 public:
  static constexpr double kFullCircle = 2 * std::numbers::pi;
  static constexpr double kNoEnd = std::numeric_limits<double>::infinity();

  // `way` outlives this object. REQUIRES: level > way.label.
  Front(const FaceWay& way, double level)
      : way_(&way), level_(level), reach_(level - way.sigma) {}

  const FaceWay& way() const { return *way_; }
  bool is_straight() const { return way_->is_segment; }
  // REQUIRES: !is_straight().
  double radius() const { return reach_; }
  PlanePoint At(double parameter) const;
  double ParameterOf(const PlanePoint& place) const;
  // From one parameter on to the other: in [0, kFullCircle) for circles.
  double Run(double from, double to) const;
  double LengthOf(double run) const {
    return is_straight() ? run : run * reach_;
  }

  // Whether both are circles and the other holds this one.
  bool IsWithin(const Front& other) const {
    return !is_straight() && !other.is_straight() &&
           Norm(way_->from - other.way_->from) + reach_ <= other.reach_;
  }
  // How far it goes on within a half-plane; kNoEnd if it does not leave that,
  // or by no more than `shallow` (a straight line: within `size`).
  double RunWithin(const HalfPlane& half_plane, double from, double shallow,
                   double size) const;

  // Adds the parts of the next `run` that lie outside of a half-plane.
  void AddOutside(const HalfPlane& half_plane, double from, double run,
                  std::vector<Interval>& parts) const;
  // Adds the parts of the next `run` in which another way is shorter than the
  // level, somewhere by more than `shallow`.
  void AddCovered(const FaceWay& other, double from, double run, double shallow,
                  std::vector<Interval>& parts) const;

 private:
  // Calls visit(run) where it crosses the line or the circle around a place,
  // not in order.
  template <typename Visit>
  void ForEachCrossing(const HalfPlane& half_plane, double from,
                       Visit visit) const;
  template <typename Visit>
  void ForEachCrossing(const PlanePoint& center, double radius, double from,
                       Visit visit) const;

  const FaceWay* way_;
  double level_;
  double reach_;
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_FRONT_H_
