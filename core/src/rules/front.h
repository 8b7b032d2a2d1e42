// What every rule shares: the distances of the vertices, and the pseudo-source
// events that a better distance sets off.

#ifndef GEODESIC_RULES_FRONT_H_
#define GEODESIC_RULES_FRONT_H_

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "geodesic/mesh.h"
#include "geodesic/query.h"
#include "queues/queue.h"
#include "tolerances.h"
#include "windows/window.h"

namespace geodesic {

template <WindowQueue Queue>
class Front {
 public:
  Front(const Mesh& mesh, const Query& query, Queue& queue)
      : mesh_(mesh),
        queue_(queue),
        distances_(mesh.vertex_count(),
                   std::numeric_limits<double>::infinity()),
        states_(mesh.vertex_count(), 0) {
    for (const Source& source : query.sources) {
      states_[source.vertex] |= kSource;
    }
  }

  const Mesh& mesh() const { return mesh_; }
  Queue& queue() { return queue_; }
  double distance(uint32_t v) const { return distances_[v]; }
  std::vector<double> TakeDistances() && { return std::move(distances_); }
  uint64_t reached() const { return reached_; }
  uint64_t bytes() const {
    return distances_.capacity() * sizeof(double) + states_.capacity();
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

  // Takes `distance` for v if it is better. A vertex that paths may bend at is
  // then queued with its distance as label (otherwise no bound on
  // what is pending holds).
  void Relax(uint32_t v, double distance) {
    double& best = distances_[v];
    if (distance >= best * (1 - kImprovement)) return;
    reached_ += std::isinf(best);
    best = distance;
    if (!(states_[v] & kSource) && !mesh_.IsPseudoSource(v)) return;
    states_[v] |= kPending;
    queue_.Push(kVertexEvent | v, distance);
  }

  // Handles the event of v: relaxes v's neighbours along their edges and calls
  // open(half_edge, origin) for every edge that v sees whole, where the
  // half-edge enters the face beyond. These are the edges opposite to v, and
  // where v lies on one (across a face without area), the other edges of the
  // face beyond. Does nothing if v has not improved since it was last expanded.
  template <typename Open>
  void Expand(uint32_t v, Open open) {
    if (!(states_[v] & kPending)) return;
    states_[v] &= ~kPending;
    const double sigma = distances_[v];
    for (HalfEdge h : mesh_.Outgoing(v)) {
      const HalfEdge opposite = Next(h);
      const HalfEdgeFrame& frame = mesh_.frame(opposite);
      Relax(mesh_.To(h), sigma + mesh_.frame(h).length);
      Relax(mesh_.Apex(h), sigma + mesh_.frame(Prev(h)).length);
      // Seen from beyond, the edge runs the other way.
      Look(mesh_.Twin(opposite),
           {.x = frame.length - frame.apex_x,
            .depth = frame.apex_y,
            .sigma = sigma},
           kMostFolds, open);
    }
  }

 private:
  enum State : uint8_t {
    kSource = 1,
    kPending = 2,  // improved since it was last expanded
  };

  // Through how many faces without area in a row a pseudo-source looks on.
  static constexpr int kMostFolds = 16;

  // Opens `half_edge`, or if the pseudo-source lies on it, what lies beyond.
  template <typename Open>
  void Look(HalfEdge half_edge, const Origin& origin, int folds, Open open) {
    if (half_edge == kNoHalfEdge) return;
    const HalfEdgeFrame& frame = mesh_.frame(half_edge);
    const bool is_on_edge = origin.depth <= kCollapsedFace * frame.length &&
                            origin.x > 0 && origin.x < frame.length;
    if (!is_on_edge || folds == 0) {
      open(half_edge, origin);
      return;
    }
    Relax(mesh_.Apex(half_edge), origin.sigma + DistanceToApex(origin, frame));
    Look(frame.left_exit, UnfoldLeft(origin, frame), folds - 1, open);
    Look(frame.right_exit,
         UnfoldRight(origin, frame, mesh_.frame(Next(half_edge)).length),
         folds - 1, open);
  }

  const Mesh& mesh_;
  Queue& queue_;
  std::vector<double> distances_;
  std::vector<uint8_t> states_;
  uint64_t reached_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_RULES_FRONT_H_
