// The sum of the angles of the faces around each vertex.

#ifndef GEODESIC_MESH_CONE_ANGLES_H_
#define GEODESIC_MESH_CONE_ANGLES_H_

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace geodesic {

// Turns a direction by one face's angle after another: a rotation costs four
// products where the angle itself would cost an arc tangent, and errs as little
// (about 2e-16 a face).
class ConeAngles {
 public:
  explicit ConeAngles(uint32_t vertices) : cones_(vertices) {}

  void Prefetch(uint32_t v) const { __builtin_prefetch(&cones_[v]); }

  // Adds the angle of the unit vector (x, y), y >= 0: from 0 to pi.
  void Add(uint32_t v, double x, double y) {
    Cone& cone = cones_[v];
    const bool was_below = cone.IsBelow();
    cone = {cone.x * x - cone.y * y, cone.x * y + cone.y * x, cone.turns};
    // By pi at the most: out of the lower half only past 2 pi.
    cone.turns += was_below & !cone.IsBelow();
  }

  // Whether the angle exceeds this one. Most need no arc tangent.
  bool Exceeds(uint32_t v, double angle) const {
    return kTurn * (cones_[v].turns + 1) > angle && Of(v) > angle;
  }

  // In radians.
  double Of(uint32_t v) const {
    const Cone& cone = cones_[v];
    const double angle = std::atan2(std::abs(cone.y), cone.x);
    return kTurn * cone.turns + (cone.IsBelow() ? kTurn - angle : angle);
  }

 private:
  static constexpr double kTurn = 2 * std::numbers::pi;

  struct Cone {
    double x = 1, y = 0;
    uint32_t turns = 0;

    // Whether the direction is at pi or beyond. Without a branch, for it cannot
    // be foreseen.
    bool IsBelow() const { return (y < 0) | ((y == 0) & (x < 0)); }
  };

  std::vector<Cone> cones_;
};

}  // namespace geodesic

#endif  // GEODESIC_MESH_CONE_ANGLES_H_
