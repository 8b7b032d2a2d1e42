// What a pseudo-source sees beyond the edges around it.

#ifndef GEODESIC_SOLVER_RULES_SIGHT_H_
#define GEODESIC_SOLVER_RULES_SIGHT_H_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geodesic/mesh.h"
#include "solver/windows/window.h"
#include "tolerances.h"

namespace geodesic {

// Opens the half-edges that the pseudo-source sees. Where it lies on one, it
// looks on through the face beyond, which may have no area; such faces may lead
// into each other in rings. Sink: as for Front::Expand. Front and Sink outlive
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

  void See(HalfEdge side, const Origin& origin, const Interval& part) {
    front_.Cross(
        side, origin, part,
        [&](HalfEdge half_edge, const Origin& seen, const Interval& through) {
          const bool is_fold = LiesOnEdge(seen, mesh_.frame(half_edge));
          bool looks_on = is_fold && known_.size() < kMostKnown;
          const View view{half_edge, seen, through};
          if (is_fold || mesh_.IsNonManifoldEdge(half_edge)) {
            const auto [begin, end] = known_.equal_range(half_edge);
            for (auto it = begin; it != end; ++it) {
              const View& known = it->second;
              if (!known.Covers(through)) continue;
              if (known.IsAsNear(seen)) return;
              looks_on = false;  // rings come back a little off at times
            }
            known_.insert({half_edge, view});
          }
          if (looks_on) {
            folds_.push_back(view);
          } else {
            sink_.Open(half_edge, pseudo_source_, seen, through);
          }
        });
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
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_SIGHT_H_
