// What every rule shares: the distances of the vertices and how paths arrive
// there, the sources, and the pseudo-source events that a better distance sets
// off.

#ifndef GEODESIC_RULES_FRONT_H_
#define GEODESIC_RULES_FRONT_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "anchors.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "queues/queue.h"
#include "surface_location.h"
#include "targets.h"
#include "tolerances.h"
#include "windows/window.h"
#include "windows/window_observer.h"

namespace geodesic {

template <WindowQueue Queue>
class Front {
 public:
  // `observer`, if any, hears of every window.
  Front(const Mesh& mesh, const Query& query, Queue& queue,
        WindowObserver* observer)
      : mesh_(mesh),
        queue_(queue),
        observer_(observer),
        targets_(mesh, query.targets),
        distances_(mesh.vertex_count(),
                   std::numeric_limits<double>::infinity()),
        states_(mesh.vertex_count(), 0) {
    if (query.trace) arrivals_.resize(mesh.vertex_count());
  }

  const Mesh& mesh() const { return mesh_; }
  Queue& queue() { return queue_; }
  const Targets& targets() const { return targets_; }
  double distance(uint32_t v) const { return distances_[v]; }
  std::span<const double> distances() const {
    return std::span(distances_).first(mesh_.vertex_count());
  }
  std::span<const Arrival> arrivals() const { return arrivals_; }
  // What bounds a window of this pseudo-source from below: the distance of a
  // vertex, the offset of an anchor.
  double PseudoSourceDistance(uint32_t pseudo_source) const {
    return distances_[pseudo_source];
  }
  // Whether the rays of pseudo-source `other` may pass by `nearer` on both its
  // sides and be the shortest there. Not if it is a vertex, since windows end
  // at vertices; nor behind the only source, or one with itself, since whoever
  // comes from behind it is farther everywhere.
  bool MayPassBy(uint32_t nearer, uint32_t other) const {
    return nearer >= mesh_.vertex_count() && nearer != other &&
           distances_.size() > mesh_.vertex_count() + 1;
  }
  uint64_t reached() const { return reached_; }
  uint64_t bytes() const {
    return distances_.capacity() * sizeof(double) + states_.capacity() +
           arrivals_.capacity() * sizeof(Arrival) + targets_.bytes();
  }
  // Fetches the face of h, then (once that has arrived) the distances of its
  // corners into cache.
  void PrefetchFace(HalfEdge h) const {
    const HalfEdge first = h - h % 3;
    __builtin_prefetch(&mesh_.frame(first));
    __builtin_prefetch(&mesh_.frame(first + 1));
    __builtin_prefetch(&mesh_.frame(first + 2));
    __builtin_prefetch(&mesh_.triangles()[h / 3]);
  }
  void PrefetchCorners(HalfEdge h) const {
    for (uint32_t v : mesh_.triangles()[h / 3]) PrefetchDistance(v);
  }
  void PrefetchDistance(uint32_t v) const {
    __builtin_prefetch(&distances_[v]);
  }

  // Whether a window on the edge from -> to is useless because paths through
  // the edge's ends and along it are shorter: if at the interval's end the one
  // from `from` is, then it is at every point of the interval before, and
  // likewise for `to`. The first two conditions of the Xin-Wang filter.
  bool EndsAreNearer(const Window& window, double length, uint32_t from,
                     uint32_t to) const {
    const auto& [begin, end] = window.interval;
    return Exceeds(window.end_distance, distances_[from] + end) ||
           Exceeds(window.begin_distance, distances_[to] + (length - begin));
  }

  // No point of the edge is farther than this: one of its ends and the edge
  // itself lead there.
  double Farthest(HalfEdge h) const {
    return (distances_[mesh_.From(h)] + distances_[mesh_.To(h)] +
            mesh_.frame(h).length) /
           2;
  }

  // Tells whoever wants to know of a window that enters the face of h.
  void Observe(HalfEdge h, const Window& window, uint32_t pseudo_source) {
    if (targets_.Watches(h / 3)) targets_.Offer(h, window, pseudo_source);
    if (observer_ != nullptr) observer_->OnWindow(h, window, pseudo_source);
  }

  // Takes `distance` for v if it is better. A vertex that paths may bend at is
  // then queued with its distance as label (otherwise no bound on
  // what is pending holds).
  void Relax(uint32_t v, double distance, const Arrival& arrival) {
    double& best = distances_[v];
    if (distance >= best * (1 - kImprovement)) return;
    reached_ += std::isinf(best);
    best = distance;
    if (!arrivals_.empty()) arrivals_[v] = arrival;
    if (!(states_[v] & kSource) && !mesh_.IsPseudoSource(v)) return;
    states_[v] |= kPending;
    queue_.Push(kVertexEvent | v, distance);
  }

  // Starts from an anchor: relaxes the vertices around it and calls
  // open(half_edge, pseudo_source, origin) for every edge that it sees whole.
  template <typename Open>
  void AddAnchor(const Anchor& anchor, Open open) {
    const auto number = static_cast<uint32_t>(distances_.size());
    const double sigma = std::ldexp(anchor.offset, -mesh_.scale_exponent());
    distances_.push_back(sigma);
    if (const auto* at = std::get_if<VertexPoint>(&anchor.begin)) {
      states_[at->vertex] |= kSource;
      Relax(at->vertex, sigma, {.pseudo_source = number});
      return;
    }
    for (const FacePoint& point : FacesAround(mesh_, anchor.begin)) {
      const Arrival straight{.pseudo_source = number};
      for (uint32_t corner = 0; corner < 3; ++corner) {
        const HalfEdge h = 3 * point.face + corner;
        const double to_corner = DistanceToCorner(mesh_, point, corner);
        if (to_corner <= kNearVertex * LongestEdgeAt(mesh_.From(h))) {
          states_[mesh_.From(h)] |= kSource;
        }
        Relax(mesh_.From(h), sigma + to_corner, straight);
        // The faces beyond an edge that holds the point are around it too.
        if (point.weights[Prev(h) % 3] == 0) continue;
        const PlanePoint at = InFrame(mesh_, point, h);
        Look(mesh_.Twin(h),
             {.x = mesh_.frame(h).length - at.x,
              .depth = std::max(at.y, kLeastHeight),
              .sigma = sigma},
             number, kMostFolds, open);
      }
      const PlanePoint from = InFrame(mesh_, point, 3 * point.face);
      targets_.OfferWithin(point.face, number, [&](const PlanePoint& to) {
        return sigma + std::hypot(to.x - from.x, to.y - from.y);
      });
    }
  }

  // Handles the event of v: relaxes v's neighbours along their edges and calls
  // open(half_edge, pseudo_source, origin) for every edge that v sees whole,
  // where the half-edge enters the face beyond. These are the edges opposite to
  // v, and where v lies on one (across a face without area), the other edges of
  // the face beyond. Does nothing if v has not improved since it was last
  // expanded.
  template <typename Open>
  void Expand(uint32_t v, Open open) {
    if (!(states_[v] & kPending)) return;
    states_[v] &= ~kPending;
    const double sigma = distances_[v];
    const Arrival along_edge{.pseudo_source = v};
    for (HalfEdge h : mesh_.Outgoing(v)) {
      const HalfEdge opposite = Next(h);
      const HalfEdgeFrame& frame = mesh_.frame(opposite);
      Relax(mesh_.To(h), sigma + mesh_.frame(h).length, along_edge);
      Relax(mesh_.Apex(h), sigma + mesh_.frame(Prev(h)).length, along_edge);
      // Seen from beyond, the edge runs the other way.
      Look(mesh_.Twin(opposite),
           {.x = frame.length - frame.apex_x,
            .depth = frame.apex_y,
            .sigma = sigma},
           v, kMostFolds, open);
    }
  }

 private:
  enum State : uint8_t {
    kSource = 1,
    kPending = 2,  // improved since it was last expanded
  };

  // Of the faces around v.
  double LongestEdgeAt(uint32_t v) const {
    double longest = 0;
    for (HalfEdge h : mesh_.Outgoing(v)) {
      longest =
          std::max({longest, mesh_.frame(h).length, mesh_.frame(Next(h)).length,
                    mesh_.frame(Prev(h)).length});
    }
    return longest;
  }

  // Through how many faces without area in a row a pseudo-source looks on.
  static constexpr int kMostFolds = 16;

  // Opens `half_edge`, or if the pseudo-source lies on it, what lies beyond.
  template <typename Open>
  void Look(HalfEdge half_edge, const Origin& origin, uint32_t pseudo_source,
            int folds, Open open) {
    if (half_edge == kNoHalfEdge) return;
    const HalfEdgeFrame& frame = mesh_.frame(half_edge);
    const bool is_on_edge = origin.depth <= kCollapsedFace * frame.length &&
                            origin.x > 0 && origin.x < frame.length;
    if (!is_on_edge || folds == 0) {
      open(half_edge, pseudo_source, origin);
      return;
    }
    Observe(half_edge, Window::Over({0, frame.length}, origin), pseudo_source);
    Relax(mesh_.Apex(half_edge), origin.sigma + DistanceToApex(origin, frame),
          {pseudo_source, half_edge, origin.x, origin.depth});
    Look(frame.left_exit, UnfoldLeft(origin, frame), pseudo_source, folds - 1,
         open);
    Look(frame.right_exit,
         UnfoldRight(origin, frame, mesh_.frame(Next(half_edge)).length),
         pseudo_source, folds - 1, open);
  }

  const Mesh& mesh_;
  Queue& queue_;
  WindowObserver* const observer_;
  Targets targets_;
  std::vector<double> distances_;  // of vertices, then offsets of anchors
  std::vector<Arrival> arrivals_;  // of vertices; empty without a trace
  std::vector<uint8_t> states_;
  uint64_t reached_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_RULES_FRONT_H_
