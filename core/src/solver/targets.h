// Distances of the query's targets, gathered from the windows that enter their
// faces.

#ifndef GEODESIC_SOLVER_TARGETS_H_
#define GEODESIC_SOLVER_TARGETS_H_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "solver/windows/window.h"
#include "surface/surface_location.h"

namespace geodesic {

// Every path to a target ends in a straight piece from a corner of its face,
// from a source in that face, or through a window on one of its half-edges.
// Lengths are in the mesh's scaled unit.
class Targets {
 public:
  Targets(const Mesh& mesh, std::span<const SurfacePoint> targets);

  size_t size() const { return targets_.size(); }

  // Whether windows into the face of h may lead to a target.
  bool Watches(HalfEdge h) const {
    return !first_in_slot_.empty() && first_in_slot_.contains(h / 3);
  }

  // Takes the paths of a window on h to the targets in its face, whose lengths
  // `mend(length, target)` mends. REQUIRES: Watches(h).
  template <typename OriginType, typename Mend>
  void Offer(HalfEdge h, const BasicWindow<OriginType>& window,
             uint32_t pseudo_source, Mend mend);

  // Takes the straight paths from a source in a face, which `distance` gives
  // for a place in the frame of the face's first half-edge.
  template <typename Distance>
  void OfferWithin(uint32_t face, uint32_t pseudo_source, Distance distance) {
    const HalfEdge first = mesh_->FirstSide(face);
    if (!Watches(first)) return;
    for (uint32_t t = FirstIn(first); t != kNone; t = targets_[t].next) {
      Take(targets_[t], distance(InFrame(*mesh_, targets_[t].point, first)),
           {.pseudo_source = pseudo_source});
    }
  }

  // What is known of target t, given the distances of the vertices.
  double Distance(size_t t, std::span<const double> vertex_distances) const;
  // Whose account is that of the target's distance (Front::AccountOf): a vertex
  // or what is in the place of a window's pseudo-source.
  uint32_t AccountHolder(size_t t,
                         std::span<const double> vertex_distances) const;
  Arrival ArrivalAt(size_t t, std::span<const double> vertex_distances,
                    std::span<const Arrival> vertex_arrivals) const;

  uint64_t bytes() const {
    return targets_.capacity() * sizeof(Target) +
           first_in_slot_.capacity() * 2 * sizeof(uint32_t);
  }

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  struct Target {
    uint32_t vertex = kNone;  // the target itself, or:
    FacePoint point;
    uint32_t next = kNone;  // target in the same face
    // Other than through a corner of the face.
    double distance = std::numeric_limits<double>::infinity();
    Arrival arrival;
  };

  struct ThroughCorner {
    uint32_t vertex;
    double distance;
  };

  void Take(Target& target, double distance, const Arrival& arrival) {
    distance = std::max(distance, 0.0);  // as MixedOrigin::PathTo
    if (!(distance < target.distance)) return;
    target.distance = distance;
    target.arrival = arrival;
  }
  // The first target in the face of h. REQUIRES: Watches(h).
  uint32_t FirstIn(HalfEdge h) const {
    return first_in_slot_.find(h / 3)->second;
  }
  ThroughCorner NearestCorner(const Target& target,
                              std::span<const double> distances) const;

  const Mesh* mesh_;
  std::vector<Target> targets_;
  // By h / 3 of the faces that hold a target.
  absl::flat_hash_map<uint32_t, uint32_t> first_in_slot_;
};

template <typename OriginType, typename Mend>
void Targets::Offer(HalfEdge h, const BasicWindow<OriginType>& window,
                    uint32_t pseudo_source, Mend mend) {
  const HalfEdgeFrame& frame = mesh_->frame(h);
  const auto& [interval, origin, begin_distance, end_distance] = window;
  for (uint32_t t = FirstIn(h); t != kNone; t = targets_[t].next) {
    const PlanePoint at = InFrame(*mesh_, targets_[t].point, h);
    const double crossing = CrossingTo(origin, at);
    // As for an apex: rays may miss the window by rounding.
    const double through = std::clamp(crossing, interval.begin, interval.end);
    if (!(std::abs(through - crossing) <= NearMiss(origin, frame, at)))
      continue;
    const double length = PathToPlace(origin, through, crossing, at);
    Take(targets_[t], mend(length, targets_[t].point),
         {pseudo_source, h, origin.x, origin.depth});
  }
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_TARGETS_H_
