// All windows that wait at a half-edge cross its face together.

#ifndef GEODESIC_SOLVER_RULES_FACE_CROSSING_H_
#define GEODESIC_SOLVER_RULES_FACE_CROSSING_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "solver/rules/face_corners.h"
#include "solver/rules/list_kernels.h"
#include "solver/rules/shadow_fan.h"
#include "solver/trimming/envelope.h"
#include "solver/windows/window.h"
#include "solver/windows/window_columns.h"

namespace geodesic {

// Loops without branches over columns. Scratch that is kept for its memory: one
// for each thread. REQUIRES: the front's origins are points, and the mesh has
// no faces without area.
template <typename Front>
class FaceCrossing {
 public:
  // The front outlives this.
  explicit FaceCrossing(const Front& front)
      : front_(front), mesh_(front.mesh()) {}

  // The windows that are to cross: sorted along their half-edge and disjoint.
  WindowColumns& list() { return list_; }

  // Takes the windows of list(), at least one, across the face of h.
  // relax(vertex, distance, arrival, ray), as Front::Relax, hears of the
  // shortest path to the apex if that improves; then hand_on(side, exit,
  // children, label) of the children across either side, if there are any: in
  // the frame that an oriented neighbour has, without those that are useless
  // (list_kernels.h), trimmed against each other. No child's label is below
  // `label`.
  template <typename Relax, typename HandOn>
  void Cross(HalfEdge h, Relax relax, HandOn hand_on) {
    const HalfEdgeFrame& frame = mesh_.frame(h);
    const FaceCorners corners(mesh_, h);
    Reserve(list_.size);
    CrossingsToApex(frame, list_, crossings_.data(), misses_.data());
    const double to_apex = ReachApex(h, corners.apex, frame, relax);
    const FaceSide<kLeft> left(mesh_, h);
    Leave(left, {left.length, front_.distance(corners.from), to_apex},
          corners.from, corners.apex, hand_on);
    const FaceSide<kRight> right(mesh_, h);
    Leave(right, {right.length, to_apex, front_.distance(corners.to)},
          corners.apex, corners.to, hand_on);
  }

 private:
  static constexpr double kUseless = std::numeric_limits<double>::infinity();

  void Reserve(size_t count) {
    children_.Reserve(count);
    const size_t room = count + WindowColumns::kPadding;
    if (crossings_.size() >= room) return;
    for (auto* column : {&crossings_, &misses_, &labels_}) {
      column->resize(2 * room);
    }
    hits_.resize(2 * room);
  }

  // Returns the apex's distance that is known then.
  template <typename Relax>
  double ReachApex(HalfEdge h, uint32_t vertex, const HalfEdgeFrame& frame,
                   Relax relax) {
    const PlanePoint apex = ApexOf(frame);
    double best = front_.distance(vertex);
    size_t nearest = list_.size;  // none
    double missed_by = 0;
    // Gathered without a branch: which windows see the apex cannot be foreseen.
    size_t hits = 0;
    for (size_t i = 0; i < list_.size; ++i) {
      hits_[hits] = static_cast<uint32_t>(i);
      hits += misses_[i] <= 0;
    }
    for (const uint32_t i : std::span(hits_).first(hits)) {
      const Origin origin = list_.OriginAt(i);
      // The point of the interval nearest to the ray through the apex; paths
      // through it to the apex are real, and straight if the ray is in there.
      const double through =
          std::clamp(crossings_[i], list_.begin[i], list_.end[i]);
      const double distance = PathToPlace(origin, through, crossings_[i], apex);
      if (!Front::Improves(distance, best)) continue;
      best = distance;
      nearest = i;
      missed_by = std::abs(through - crossings_[i]);
    }
    if (nearest < list_.size) {
      const Origin origin = list_.OriginAt(nearest);
      relax(vertex, best,
            Arrival{list_.pseudo_source[nearest], h, origin.x, origin.depth},
            RayPast(mesh_, h, origin, missed_by));
    }
    return best;
  }

  // Seen from beyond, the side runs from -> to.
  template <Side kSide, typename HandOn>
  void Leave(const FaceSide<kSide>& side, const ExitEdge& edge, uint32_t from,
             uint32_t to, HandOn hand_on) {
    if (side.exit == kNoHalfEdge) return;
    size_t first = 0, last = list_.size;
    const auto reaches = [&](size_t i) {
      return side.IsReached(list_.IntervalAt(i), crossings_[i]);
    };
    if constexpr (kSide == kLeft) {
      while (last > 0 && !reaches(last - 1)) --last;
    } else {
      while (first < last && !reaches(first)) ++first;
    }
    if (first == last) return;
    ChildrenAcross(side, edge, list_, crossings_.data(), first, last, children_,
                   labels_.data());
    if constexpr (Front::Goal::kDirects) {
      KeysOf(children_, side.length, front_.goal().At(from, to),
             labels_.data());
    }
    const double label = TrimChildren(side.length);
    if (children_.size > 0)
      hand_on(side.half_edge, side.exit, children_, label);
  }

  // Trims children_, whose edge is this long. Returns a lower bound on their
  // labels.
  double TrimChildren(double length) {
    double least = kUseless, most = 0;
    for (size_t i = 0; i < children_.size; ++i) {
      least = std::min(least, labels_[i]);
      most = std::max(most, labels_[i]);
    }
    if (most == kUseless) {
      children_.KeepIf(0, [this](size_t i) { return labels_[i] != kUseless; });
    }
    envelope_.Trim(length, children_);
    return least;
  }

  const Front& front_;
  const Mesh& mesh_;
  WindowColumns list_, children_;
  std::vector<double> crossings_, misses_, labels_;
  std::vector<uint32_t> hits_;
  Envelope envelope_;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_FACE_CROSSING_H_
