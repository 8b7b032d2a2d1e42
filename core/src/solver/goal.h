// What a directed computation heads for: lower bounds on the rest of the way
// from any vertex.

#ifndef GEODESIC_SOLVER_GOAL_H_
#define GEODESIC_SOLVER_GOAL_H_

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "geodesic/landmarks.h"
#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "solver/windows/window.h"
#include "surface/straight_line.h"

namespace geodesic {

// Bounds at the ends of an edge, the longest path that is of any use, and
// whether windows wait with their label.
struct EdgeGoal {
  double from_bound, to_bound;
  double limit;
  bool orders_by_label;
};

// A lower bound on all paths to the goal that go through a window: infinite if
// that exceeds the limit. From x on the edge A -> B the rest of the way is no
// shorter than the bound at A less |Ax|, nor than the bound at B less |xB|. Of
// the sum with the distance at x, the first is least at the window's end, the
// second at its begin; and neither label nor rest are less anywhere than the
// last one takes them.
inline double KeyOf(const Window& window, double label, double length,
                    const EdgeGoal& goal) {
  const double by_from =
      window.end_distance - window.interval.end + goal.from_bound;
  const double by_to =
      window.begin_distance - (length - window.interval.begin) + goal.to_bound;
  const double by_label =
      label + (goal.from_bound + goal.to_bound - length) / 2;
  double key = std::max(label, by_from);
  key = by_to > key ? by_to : key;
  key = by_label > key ? by_label : key;
  if (!(key <= goal.limit)) return std::numeric_limits<double>::infinity();
  return goal.orders_by_label ? label : key;
}

// For computations that head for all there is.
struct NoGoal {
  static constexpr bool kDirects = false;
};

// For computations that head for what is near: windows and vertices wait with
// their label, those beyond the limit not at all.
struct NearEdge {
  double limit;
};

inline double KeyOf(const Window&, double label, double, const NearEdge& edge) {
  return label <= edge.limit ? label : std::numeric_limits<double>::infinity();
}

class NearGoal {
 public:
  static constexpr bool kDirects = true;

  double Bound(uint32_t) const { return 0; }
  double limit() const { return limit_; }
  void set_limit(double limit) { limit_ = limit; }
  bool orders_by_label() const { return true; }
  NearEdge At(uint32_t, uint32_t) const { return {limit_}; }

 private:
  double limit_ = std::numeric_limits<double>::infinity();
};

// For one thread. Bounds are computed for vertices that are asked about only.
class Goal {
 public:
  static constexpr bool kDirects = true;

  explicit Goal(const Mesh& mesh)
      : mesh_(mesh), bounds_(mesh.vertex_count(), kUnknown) {}

  // `landmarks` may be null; they outlive the search.
  void Aim(const SurfacePoint& target, const Landmarks* landmarks);
  bool has_landmarks() const { return landmarks_ != nullptr; }
  // From now on, `bound` is another lower bound on the rest of the way from a
  // vertex. Valid until Aim.
  void Refine(std::function<double(uint32_t)> bound);
  // Forgets what was asked about since Aim. O(that).
  void Clear();

  // No path from v to the target is shorter.
  double Bound(uint32_t v) const {
    const double bound = bounds_[v];
    return bound >= 0 ? bound : Compute(v);
  }
  // Longer paths are of no use.
  double limit() const { return limit_; }
  void set_limit(double limit) { limit_ = limit; }
  // Whether what is pending goes in the order of its labels. Otherwise in that
  // of lower bounds on the whole way.
  bool orders_by_label() const { return orders_by_label_; }
  void set_orders_by_label(bool value) { orders_by_label_ = value; }
  EdgeGoal At(uint32_t from, uint32_t to) const {
    return {Bound(from), Bound(to), limit_, orders_by_label_};
  }

  uint64_t bytes() const {
    return bounds_.capacity() * sizeof(double) +
           known_.capacity() * sizeof(uint32_t);
  }

 private:
  static constexpr double kUnknown = -1;

  double Compute(uint32_t v) const;

  const Mesh& mesh_;
  const Landmarks* landmarks_ = nullptr;
  SpacePoint target_;
  Landmarks::Place from_landmarks_;
  std::function<double(uint32_t)> refined_;  // may be none
  double limit_ = std::numeric_limits<double>::infinity();
  bool orders_by_label_ = false;
  // A cache: Bound changes nothing that others see.
  mutable std::vector<double> bounds_;
  mutable std::vector<uint32_t> known_;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_GOAL_H_
