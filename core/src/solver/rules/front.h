// What every rule shares: the distances of the vertices and how paths arrive
// there, the sources, and the pseudo-source events that a better distance sets
// off.

#ifndef GEODESIC_SOLVER_RULES_FRONT_H_
#define GEODESIC_SOLVER_RULES_FRONT_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "mesh/same_edges.h"
#include "solver/accuracy.h"
#include "solver/goal.h"
#include "solver/queues/queue.h"
#include "solver/rules/shadow_fan.h"
#include "solver/targets.h"
#include "solver/windows/mixed_origin.h"
#include "solver/windows/window.h"
#include "solver/windows/window_observer.h"
#include "surface/anchors.h"
#include "surface/straight_line.h"
#include "surface/surface_location.h"
#include "tolerances.h"

namespace geodesic {

// OriginType as for BasicWindow. GoalType: Goal if the computation is directed
// at its targets; windows and vertices then wait with a lower bound on the
// whole way (goal.h) in place of their label, those beyond the goal's limit not
// at all. AccuracyType: WithinTolerance if windows are merged; distances are
// then lower bounds, and those of vertices have accounts (accuracy.h).
template <WindowQueue QueueType, typename OriginType,
          typename GoalType = NoGoal, typename AccuracyType = Exact>
class Front {
 public:
  using Queue = QueueType;
  using Origin = OriginType;
  using Goal = GoalType;
  using Accuracy = AccuracyType;
  using Window = BasicWindow<Origin>;

  // `observer`, if any, hears of every window.
  Front(const Mesh& mesh, const Query& query, Queue& queue,
        WindowObserver* observer, Goal goal = {}, Accuracy accuracy = {})
      : mesh_(mesh),
        queue_(queue),
        observer_(observer),
        goal_(std::move(goal)),
        accuracy_(accuracy),
        targets_(mesh, query.targets),
        distances_(mesh.vertex_count(),
                   std::numeric_limits<double>::infinity()),
        states_(mesh.vertex_count(), 0) {
    if (query.trace) arrivals_.resize(mesh.vertex_count());
    if (!mesh.HasCollapsedFaces()) incoming_.resize(mesh.vertex_count());
    if constexpr (Accuracy::kMerges) accounts_.resize(mesh.vertex_count());
  }

  // Forgets all, and begins with the targets of another query. O(vertices
  // reached); the first time with a trace O(V).
  void Restart(const Query& query) {
    for (const uint32_t v : reached_list_) {
      distances_[v] = std::numeric_limits<double>::infinity();
      states_[v] = 0;
      if (!incoming_.empty()) incoming_[v] = {};
      if (!arrivals_.empty()) arrivals_[v] = {};
    }
    if (query.trace) arrivals_.resize(mesh_.vertex_count());
    reached_list_.clear();
    distances_.resize(mesh_.vertex_count());
    anchor_places_.clear();
    has_free_anchor_ = false;
    reached_ = 0;
    targets_ = Targets(mesh_, query.targets);
  }

  // Forgets distances that may be too long because shorter paths lie beyond the
  // goal's limit, if bounds agree along edges. O(vertices reached).
  // REQUIRES: a goal; nothing is pending.
  void ForgetBeyondGoal() {
    for (const uint32_t v : reached_list_) {
      if (distances_[v] + goal_.Bound(v) <= goal_.limit()) continue;
      distances_[v] = std::numeric_limits<double>::infinity();
    }
  }

  const Mesh& mesh() const { return mesh_; }
  Queue& queue() { return queue_; }
  Goal& goal() { return goal_; }
  const Goal& goal() const { return goal_; }
  const Accuracy& accuracy() const { return accuracy_; }
  const Targets& targets() const { return targets_; }
  Targets& targets() { return targets_; }
  double distance(uint32_t v) const { return distances_[v]; }
  // No shortest path to v is longer.
  double UpperBound(uint32_t v) const {
    if constexpr (Accuracy::kMerges) {
      return distances_[v] + static_cast<double>(accounts_[v]);
    } else {
      return distances_[v];
    }
  }
  // By how much the distances of a window of this pseudo-source may be below
  // those of real paths.
  double AccountOf(uint32_t pseudo_source) const {
    if constexpr (Accuracy::kMerges) {
      if (IsMerged(pseudo_source)) return AccountOfMerged(pseudo_source);
      return pseudo_source < accounts_.size() ? accounts_[pseudo_source] : 0;
    } else {
      return 0;
    }
  }
  std::span<const double> distances() const {
    return std::span(distances_).first(mesh_.vertex_count());
  }
  std::span<const Arrival> arrivals() const { return arrivals_; }
  // What bounds a window of this pseudo-source from below: the distance of a
  // vertex, the offset of an anchor. Infinite of a merged window, which no
  // better distance of a vertex makes useless.
  double PseudoSourceDistance(uint32_t pseudo_source) const {
    if constexpr (Accuracy::kMerges) {
      if (IsMerged(pseudo_source)) {
        return std::numeric_limits<double>::infinity();
      }
    }
    return distances_[pseudo_source];
  }
  // Whether windows of other pseudo-sources may hold points on both sides of
  // this one. At a vertex they may not, since windows end there; nor at the
  // only source, since a path from behind it is longer everywhere.
  bool MayBePassedBy(uint32_t pseudo_source) const {
    return pseudo_source >= mesh_.vertex_count() && anchor_count() > 1;
  }
  // Whether two windows may change over more than once on an edge: only beside
  // a pseudo-source that can be passed by, or where rays that coincide have
  // come by different faces of a edge of three faces or more.
  bool MayChangeOverTwice() const {
    return (has_free_anchor_ && anchor_count() > 1) ||
           mesh_.HasNonManifoldEdges();
  }
  size_t anchor_count() const {
    return distances_.size() - mesh_.vertex_count();
  }
  uint64_t reached() const { return reached_; }
  // The vertices that are; with a goal only.
  std::span<const uint32_t> reached_list() const { return reached_list_; }
  uint64_t bytes() const {
    return distances_.capacity() * sizeof(double) + states_.capacity() +
           accounts_.capacity() * sizeof(float) +
           incoming_.capacity() * sizeof(IncomingRay) +
           arrivals_.capacity() * sizeof(Arrival) + targets_.bytes() +
           reached_list_.capacity() * sizeof(uint32_t);
  }
  // Fetches the distances of the corners of h's face into cache, once that face
  // is there (mesh/prefetch.h).
  void PrefetchCorners(HalfEdge h) const {
    for (uint32_t v : mesh_.TriangleOf(h)) PrefetchDistance(v);
  }
  void PrefetchDistance(uint32_t v) const {
    __builtin_prefetch(&distances_[v]);
    if constexpr (Accuracy::kMerges) __builtin_prefetch(&accounts_[v]);
  }

  // Whether a window on the edge from -> to is useless because paths through
  // the edge's ends and along it are shorter: if at the interval's end the one
  // from `from` is, then it is at every point of the interval before, and
  // likewise for `to`. The first two conditions of the Xin-Wang filter.
  bool EndsAreNearer(const Window& window, double length, uint32_t from,
                     uint32_t to) const {
    const auto& [begin, end] = window.interval;
    return Exceeds(window.end_distance, UpperBound(from) + end) ||
           Exceeds(window.begin_distance, UpperBound(to) + (length - begin));
  }

  // A window on h, unless it is too narrow or useless as above.
  std::optional<Window> UsefulWindow(HalfEdge h, const Origin& origin,
                                     const Interval& interval) const {
    const double length = mesh_.frame(h).length;
    if (IsLost(interval, origin, length)) return std::nullopt;
    const Window window = Window::Over(interval, origin);
    if (EndsAreNearer(window, length, mesh_.From(h), mesh_.To(h)) ||
        (mesh_.HasCollapsedFaces() && EndsSeeAll(h, window))) {
      return std::nullopt;
    }
    return window;
  }

  // Whether the wavefront has passed the edge: one of its ends and the edge
  // itself lead to its farthest point.
  bool IsPassed(HalfEdge h) const {
    const double farthest = (distances_[mesh_.From(h)] +
                             distances_[mesh_.To(h)] + mesh_.frame(h).length) /
                            2;
    return farthest <= queue_.SettledRadius();
  }

  // Whether Observe(h) does anything.
  bool Watches(HalfEdge h) const {
    return observer_ != nullptr || targets_.Watches(h);
  }
  // Tells the targets and the observer of a window that enters the face of h.
  void Observe(HalfEdge h, const Window& window, uint32_t pseudo_source) {
    if (targets_.Watches(h)) {
      targets_.Offer(h, window, pseudo_source,
                     [&](double distance, const FacePoint& target) {
                       return AtLeastStraight(distance, pseudo_source, target);
                     });
    }
    if (observer_ != nullptr) {
      observer_->OnWindow(h, AsMixed(window), pseudo_source);
    }
  }

  // Whether a distance is better than the best one known, by more than
  // rounding.
  static bool Improves(double distance, double best) {
    return distance < best * (1 - kImprovement);
  }

  // Whether it is better by more than what windows seem to gain by going round
  // faces without area. A path cannot be followed back round these.
  static bool ImprovesOnLoops(double distance, double best) {
    return distance < best - std::min(kLoopTie, kAlongEdge * best);
  }

  // Whether Relax changes anything.
  bool Takes(uint32_t v, double distance, const Arrival& arrival) const {
    if constexpr (Accuracy::kMerges) {
      if (Improves(distance + AccountOf(arrival.pseudo_source),
                   UpperBound(v))) {
        return true;
      }
    }
    return Improves(distance, distances_[v]);
  }

  // Takes `distance` for v if it is better. If paths may bend at v, or the path
  // to v bends already, v is queued with its distance as label. `ray`: where
  // the path comes from, if that is known.
  void Relax(uint32_t v, double distance, const Arrival& arrival,
             const IncomingRay& ray = {}) {
    if constexpr (std::is_same_v<Origin, MixedOrigin>) {
      distance = std::max(distance, 0.0);  // as MixedOrigin::PathTo
    }
    if constexpr (Accuracy::kMerges) {
      if (!Takes(v, distance, arrival)) return;
      KeepAccount(v, distance, arrival);
    }
    double& best = distances_[v];
    if (!Improves(distance, best)) return;
    if (arrival.entry != kNoHalfEdge) {
      if (mesh_.HasCollapsedFaces() && !ImprovesOnLoops(distance, best)) return;
      distance =
          AtLeastStraight(distance, arrival.pseudo_source, VertexPoint{v});
      if (!Improves(distance, best)) return;
    }
    if constexpr (Goal::kDirects) {
      if (std::isinf(best)) reached_list_.push_back(v);
    }
    reached_ += std::isinf(best);
    best = distance;
    if (!arrivals_.empty()) arrivals_[v] = arrival;
    if (!(states_[v] & kSource) && !mesh_.IsPseudoSource(v) && !ray.is_bent()) {
      // The windows that brought a straight path pass v on both sides.
      states_[v] &= ~kPending;
      return;
    }
    if (!incoming_.empty()) incoming_[v] = ray;
    double order = distance;
    if constexpr (Goal::kDirects) {
      const double key = distance + goal_.Bound(v);
      if (!(key <= goal_.limit())) return;
      if (!goal_.orders_by_label()) order = key;
    }
    states_[v] |= kPending;
    queue_.Push(kVertexEvent | v, order);
  }

  // What a window on h with this label waits with; infinite if it need not.
  double KeyOf(HalfEdge h, const Window& window, double label) const {
    if constexpr (Goal::kDirects) {
      return geodesic::KeyOf(window, label, mesh_.frame(h).length,
                             goal_.At(mesh_.From(h), mesh_.To(h)));
    } else {
      return label;
    }
  }

  // Whether what crosses `side` has to be followed into the face of `beyond`.
  // Of faces with the same corners the first will do, and no path goes from one
  // of them into another, but to a place in it. What has entered a copy for the
  // sake of such a place goes no farther (MmpRule, ListWorker): it leaves the
  // first of them as well.
  bool MayEnter(HalfEdge side, HalfEdge beyond) const {
    if (!mesh_.HasCopies() || Watches(beyond)) return true;
    return !mesh_.IsCopy(beyond) && (mesh_.Apex(beyond) != mesh_.Apex(side) ||
                                     !HaveSameEdges(mesh_, beyond, side));
  }

  // Calls enter(half_edge, origin, interval) for every face beyond `side` that
  // a window enters; origin and interval are given in the frame that an
  // oriented neighbour has.
  template <typename Enter>
  void Cross(HalfEdge side, const Origin& origin, const Interval& interval,
             Enter enter) const {
    const double length = mesh_.frame(side).length;
    mesh_.ForEachBeyond(side, [&](HalfEdge half_edge, bool is_mirrored) {
      if (!MayEnter(side, half_edge)) return;
      if (is_mirrored) {
        enter(half_edge, Mirror(origin, length), Mirror(interval, length));
      } else {
        enter(half_edge, origin, interval);
      }
    });
  }

  // Whether v is where a path begins.
  bool IsSource(uint32_t v) const { return (states_[v] & kSource) != 0; }
  void MarkSource(uint32_t v) { states_[v] |= kSource; }

  // Takes an anchor in: its number, and `bound`, what PseudoSourceDistance says
  // of it. What it sees is opened by AddAnchor (anchor_seeding.h).
  uint32_t NumberAnchor(const Anchor& anchor, double bound) {
    const auto number = static_cast<uint32_t>(distances_.size());
    has_free_anchor_ = has_free_anchor_ ||
                       !std::holds_alternative<VertexPoint>(anchor.begin) ||
                       anchor.is_segment;
    distances_.push_back(bound);
    anchor_places_.push_back(anchor.is_segment ? SpacePoint()
                                               : InSpace(mesh_, anchor.begin));
    return number;
  }

  // Whether v has improved since its event was last taken.
  bool TakeEvent(uint32_t v) {
    if (!(states_[v] & kPending)) return false;
    states_[v] &= ~kPending;
    return true;
  }

  // Whether nothing around v is hidden behind it: its path comes from nowhere
  // known, or one cannot simply turn around v, from face to face.
  bool SeesAllAround(uint32_t v) const {
    return incoming_.empty() || !incoming_[v].is_known() || IsSource(v) ||
           !HasRegularFan(v);
  }
  // REQUIRES: !SeesAllAround(v).
  const IncomingRay& IncomingAt(uint32_t v) const { return incoming_[v]; }

 private:
  enum State : uint8_t {
    kSource = 1,
    kPending = 2,  // improved since it was last expanded
  };

  // What remains between the bounds of v once `distance` is relaxed.
  void KeepAccount(uint32_t v, double distance, const Arrival& arrival) {
    const double lower = std::min(distances_[v], distance);
    const double upper =
        std::min(UpperBound(v), distance + AccountOf(arrival.pseudo_source));
    if (std::isinf(upper)) return;
    accounts_[v] = RoundedUp(std::max(upper - lower, 0.0));
  }

  // Whether one can simply turn around v, from face to face.
  bool HasRegularFan(uint32_t v) const {
    if (mesh_.IsNonManifold(v)) return false;
    return !mesh_.HasIrregularEdges() ||
           std::ranges::none_of(mesh_.Outgoing(v), [this](HalfEdge h) {
             return mesh_.IsIrregularEdge(h) || mesh_.IsIrregularEdge(Prev(h));
           });
  }

  // Whether a window ties with paths through an end of h that sees all around
  // it, and so all that the window would. Windows that run along faces without
  // area do, and they wind round these for long.
  bool EndsSeeAll(HalfEdge h, const Window& window) const {
    const double length = mesh_.frame(h).length;
    const double longest = mesh_.LongestSide(h);
    const double most = kAlongEdge * window.Label();
    const auto ties = [&](uint32_t end, double along, double distance) {
      return mesh_.IsPseudoSource(end) &&
             distances_[end] + along <=
                 distance + std::min(most, kLoopTie * (longest + distance));
    };
    return ties(mesh_.From(h), window.interval.end, window.end_distance) ||
           ties(mesh_.To(h), length - window.interval.begin,
                window.begin_distance);
  }

  // A distance by way of windows, but no less than straight through space from
  // the pseudo-source: unfolding rounds by about the same length everywhere,
  // which is much of a way that is very short.
  double AtLeastStraight(double distance, uint32_t pseudo_source,
                         const SurfacePoint& point) const {
    const double sigma = PseudoSourceDistance(pseudo_source);
    if (distance - sigma > kShortWay || std::isinf(sigma)) return distance;
    const SpacePoint from =
        pseudo_source < mesh_.vertex_count()
            ? SpacePoint{.vertex = pseudo_source}
            : anchor_places_[pseudo_source - mesh_.vertex_count()];
    return std::max(
        distance, sigma + StraightDistance(mesh_, from, InSpace(mesh_, point)));
  }

  const Mesh& mesh_;
  Queue& queue_;
  WindowObserver* const observer_;
  Goal goal_;
  Accuracy accuracy_;
  Targets targets_;
  std::vector<double> distances_;  // of vertices, then offsets of anchors
  std::vector<SpacePoint> anchor_places_;  // of those that are points
  std::vector<float> accounts_;            // of vertices; empty if exact
  std::vector<Arrival> arrivals_;          // of vertices; empty without a trace
  std::vector<uint8_t> states_;
  // Of pseudo-sources: whence their shortest path comes. Empty where the mesh
  // has faces without area.
  std::vector<IncomingRay> incoming_;
  bool has_free_anchor_ = false;  // one that is not a vertex
  uint64_t reached_ = 0;
  std::vector<uint32_t> reached_list_;  // with a goal only
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_FRONT_H_
