// What a pseudo-source sees beyond the edges around it, and who is told.

#ifndef GEODESIC_SOLVER_RULES_SIGHT_H_
#define GEODESIC_SOLVER_RULES_SIGHT_H_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "solver/rules/shadow_fan.h"
#include "solver/rules/wide_edges.h"
#include "solver/windows/window.h"
#include "tolerances.h"

namespace geodesic {

// Opens the half-edges that the pseudo-source sees. Where it lies on one, it
// looks on through the face beyond, which may have no area; such faces may lead
// into each other in rings. Sink: as for Expand. Front and Sink outlive
// it.
template <typename Front, typename Sink>
class Sight {
 public:
  using Origin = typename Front::Origin;

  Sight(const Front& front, uint32_t pseudo_source, Sink& sink)
      : front_(front),
        mesh_(front.mesh()),
        pseudo_source_(pseudo_source),
        sink_(sink) {}

  // Opens what is seen across a part of `side`. `origin` as for Front::Cross.
  void Across(HalfEdge side, const Origin& origin, const Interval& part) {
    See(side, origin, part);
    while (!folds_.empty()) {
      const View fold = folds_.back();
      folds_.pop_back();
      LookOn(fold);
    }
  }

  // Faces that were looked at beyond irregular edges.
  uint64_t faces() const { return faces_; }

 private:
  // A part of a half-edge that is seen from `origin`.
  struct View {
    HalfEdge half_edge;
    Origin origin;
    Interval part;

    bool Covers(const Interval& other) const {
      return part.begin <= other.begin && other.end <= part.end;
    }
    // Whether all of the part is as near as from `other`, but for rounding.
    bool IsAsNear(const Origin& other) const {
      return std::abs(origin.x - other.x) <= kRoundedPlace &&
             origin.depth <= other.depth + kRoundedPlace;
    }
  };

  // So that a pseudo-source is done soon, however many faces share its edges.
  static constexpr size_t kMostKnown = size_t{1} << 16;
  // Ten milliseconds, about. Once so many faces were looked at, what is beyond
  // more edges of three faces or more waits, as it does beyond wide edges.
  static constexpr uint64_t kMostAtOnce = uint64_t{1} << 15;

  // The first view across an edge of three faces or more. The half-edges that
  // it came to are noted in known_ only when there is another.
  struct FirstView {
    View across;
    bool is_noted = false;
  };

  void See(HalfEdge side, const Origin& origin, const Interval& part) {
    const size_t sharing = mesh_.HalfEdgesAt(side).size();
    faces_ += sharing;
    const bool is_shared = sharing > 2;
    const bool is_first = is_shared && NoteView(side, View{side, origin, part});
    if constexpr (ToldOfWideEdges<Sink>) {
      if (is_first && (IsWideEdge(mesh_, side) || faces_ > kMostAtOnce) &&
          !LiesOnEdge(origin, mesh_.frame(side))) {
        known_count_ += sharing;
        sink_.OpenBeyond(side, pseudo_source_, origin, part);
        return;
      }
    }
    front_.Cross(
        side, origin, part,
        [&](HalfEdge half_edge, const Origin& seen, const Interval& through) {
          const bool is_fold = LiesOnEdge(seen, mesh_.frame(half_edge));
          bool looks_on = is_fold && known_count_ < kMostKnown;
          const View view{half_edge, seen, through};
          if (is_first) {
            ++known_count_;
          } else if (is_fold || is_shared) {
            const auto [begin, end] = known_.equal_range(half_edge);
            for (auto it = begin; it != end; ++it) {
              const View& known = it->second;
              if (!known.Covers(through)) continue;
              if (known.IsAsNear(seen)) return;
              looks_on = false;  // rings come back a little off at times
            }
            known_.insert({half_edge, view});
            ++known_count_;
          }
          if (looks_on) {
            folds_.push_back(view);
          } else {
            sink_.Open(half_edge, pseudo_source_, seen, through);
          }
        });
  }

  // Whether it is the first across that edge. If not, the first is in known_.
  bool NoteView(HalfEdge side, const View& across) {
    const auto [it, is_first] =
        first_views_.try_emplace(mesh_.FirstOfEdge(side), FirstView{across});
    if (is_first) return true;
    FirstView& first = it->second;
    if (first.is_noted) return false;
    first.is_noted = true;
    front_.Cross(
        first.across.half_edge, first.across.origin, first.across.part,
        [&](HalfEdge half_edge, const Origin& seen, const Interval& through) {
          known_.insert({half_edge, {half_edge, seen, through}});
        });
    return false;
  }

  void LookOn(const View& fold) {
    const HalfEdge half_edge = fold.half_edge;
    const Origin& origin = fold.origin;
    const Interval& part = fold.part;
    const HalfEdgeFrame& frame = mesh_.frame(half_edge);
    sink_.Observe(half_edge, Front::Window::Over(part, origin), pseudo_source_);
    if (mesh_.IsCopy(half_edge)) return;
    const PlanePoint apex = ApexOf(frame);
    const double crossing = CrossingTo(origin, apex);
    const double through = std::clamp(crossing, part.begin, part.end);
    sink_.Relax(mesh_.Apex(half_edge),
                PathToPlace(origin, through, crossing, apex),
                {pseudo_source_, half_edge, origin.x, origin.depth});
    // All of both sides is seen, but for what an end of the edge hides.
    const bool hides = EndsHide(origin, frame);
    const Interval edge{0, frame.length};
    const auto look_on = [&](const auto& side) {
      Interval seen{0, side.length};
      if (hides) {
        if (!side.IsReached(edge, crossing)) return;
        seen = side.InExit(side.Hit(origin, edge, crossing));
      }
      if (seen.begin < seen.end) {
        See(side.half_edge, Unfold(side, origin), seen);
      }
    };
    look_on(FaceSide<kLeft>(mesh_, half_edge));
    look_on(FaceSide<kRight>(mesh_, half_edge));
  }

  const Front& front_;
  const Mesh& mesh_;
  const uint32_t pseudo_source_;
  Sink& sink_;
  std::vector<View> folds_;  // to look on from
  // Of half-edges to which several ways lead: round a ring, or by one of
  // several faces with the same corners.
  std::unordered_multimap<HalfEdge, View> known_;
  size_t known_count_ = 0;  // with those not noted yet
  // By the lowest half-edges of the edges.
  std::unordered_map<HalfEdge, FirstView> first_views_;
  uint64_t faces_ = 0;
};

// A sink for AddAnchor and Expand: what they find is applied at
// once.
template <typename Front, typename Rule>
class DirectSink {
 public:
  static constexpr bool kTakesWideEdges = ToldOfWideEdges<Rule>;

  // Both outlive the sink.
  DirectSink(Front& front, Rule& rule) : front_(front), rule_(rule) {}

  void Relax(uint32_t vertex, double distance, const Arrival& arrival,
             const IncomingRay& ray = {}) {
    front_.Relax(vertex, distance, arrival, ray);
  }
  void Observe(HalfEdge h, const typename Front::Window& window,
               uint32_t pseudo_source) {
    front_.Observe(h, window, pseudo_source);
  }
  void Open(HalfEdge half_edge, uint32_t pseudo_source,
            const typename Front::Origin& origin, const Interval& interval) {
    rule_.Open(half_edge, pseudo_source, origin, interval);
  }
  void OpenBeyond(HalfEdge side, uint32_t pseudo_source,
                  const typename Front::Origin& origin,
                  const Interval& interval) requires ToldOfWideEdges<Rule> {
    rule_.OpenBeyond(side, pseudo_source, origin, interval);
  }

 private:
  Front& front_;
  Rule& rule_;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_SIGHT_H_
