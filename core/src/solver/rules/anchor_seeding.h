// How a front starts: from the points and segments of its sources.

#ifndef GEODESIC_SOLVER_RULES_ANCHOR_SEEDING_H_
#define GEODESIC_SOLVER_RULES_ANCHOR_SEEDING_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <variant>

#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "solver/curve_segment.h"
#include "solver/rules/sight.h"
#include "solver/rules/wide_edges.h"
#include "solver/windows/mixed_origin.h"
#include "solver/windows/window.h"
#include "surface/anchors.h"
#include "surface/surface_location.h"
#include "tolerances.h"

namespace geodesic {

template <typename Front, typename Sink>
class AnchorSeeding {
 public:
  AnchorSeeding(Front& front, Sink& sink)
      : front_(front), mesh_(front.mesh()), sink_(sink) {}

  // Returns how many faces were looked at.
  uint64_t Add(const Anchor& anchor) {
    const double sigma = std::ldexp(anchor.offset, -mesh_.scale_exponent());
    if (!anchor.is_segment) {
      return AddPoint(anchor, sigma, front_.NumberAnchor(anchor, sigma));
    }
    // Distances at edges do not tell whether a segment's windows are stale: it
    // never improves.
    const uint32_t number =
        front_.NumberAnchor(anchor, std::numeric_limits<double>::infinity());
    if constexpr (std::is_same_v<typename Front::Origin, MixedOrigin>) {
      return AddSegment(anchor, sigma, number);
    }
    return 0;
  }

 private:
  // No edge is longer, in the scaled unit.
  static constexpr double kLongestEdge = 2;

  uint64_t AddPoint(const Anchor& anchor, double sigma, uint32_t number) {
    const Arrival straight{.pseudo_source = number};
    if (const auto* at = std::get_if<VertexPoint>(&anchor.begin)) {
      front_.MarkSource(at->vertex);
      front_.Relax(at->vertex, sigma, straight);
      return 1;
    }
    Sight sight(front_, number, sink_);
    // An edge may have very many faces: not again for each of them.
    const auto* on_edge = std::get_if<EdgePoint>(&anchor.begin);
    const auto is_end = [&](uint32_t v) {
      return on_edge != nullptr && (v == on_edge->from || v == on_edge->to);
    };
    bool knows_ends = false;
    uint64_t faces = 0;
    for (const FacePoint& point : FacesAround(mesh_, anchor.begin)) {
      for (uint32_t corner = 0; corner < 3; ++corner) {
        const HalfEdge h = mesh_.FirstSide(point.face) + corner;
        const double to_corner = DistanceToCorner(mesh_, point, corner);
        if (!(knows_ends && is_end(mesh_.From(h)))) {
          faces += LookAtVertex(mesh_.From(h), to_corner);
        }
        front_.Relax(mesh_.From(h), sigma + to_corner, straight);
        // The faces beyond an edge that holds the point are around it too.
        if (point.weights[Prev(h) % 3] == 0) continue;
        const PlanePoint at = InFrame(mesh_, point, h);
        const double length = mesh_.frame(h).length;
        sight.Across(h,
                     {.x = length - at.x,
                      .depth = std::max(at.y, kLeastHeight),
                      .sigma = sigma},
                     {0, length});
      }
      const PlanePoint from =
          InFrame(mesh_, point, mesh_.FirstSide(point.face));
      front_.targets().OfferWithin(
          point.face, number, [&](const PlanePoint& to) {
            return sigma + std::hypot(to.x - from.x, to.y - from.y);
          });
      knows_ends = true;
      ++faces;
    }
    return faces + sight.faces();
  }

  // A source so near to a vertex is a source there. Returns how many faces were
  // looked at.
  uint64_t LookAtVertex(uint32_t v, double distance) {
    if (front_.IsSource(v) || distance > kNearVertex * kLongestEdge) return 0;
    double longest = 0;
    for (HalfEdge h : mesh_.Outgoing(v)) {
      longest = std::max(longest, mesh_.LongestSide(h));
    }
    if (distance <= kNearVertex * longest) front_.MarkSource(v);
    return mesh_.Outgoing(v).size();
  }

  // In each of the faces that hold it.
  uint64_t AddSegment(const Anchor& anchor, double sigma, uint32_t number) {
    uint64_t faces = std::min(MostFacesAround(mesh_, anchor.begin),
                              MostFacesAround(mesh_, anchor.end));
    for (const CurveSegment& segment : SegmentsOf(mesh_, anchor)) {
      const HalfEdge first = mesh_.FirstSide(segment.face());
      const Arrival straight{.pseudo_source = number};
      for (uint32_t corner = 0; corner < 3; ++corner) {
        FacePoint at{.face = segment.face()};
        at.weights[corner] = 1;
        front_.Relax(mesh_.From(first + corner),
                     sigma + segment.DistanceTo(InFrame(mesh_, at, first)),
                     straight);
      }
      for (HalfEdge h = first; h < first + 3; ++h) {
        auto beam = segment.BeamAcross(h);
        if (!beam.has_value()) continue;
        beam->origin.sigma += sigma;
        if constexpr (ToldOfWideEdges<Sink>) {
          if (IsWideEdge(mesh_, h)) {
            sink_.OpenBeyond(h, number, beam->origin, beam->interval);
            continue;
          }
        }
        faces += 1 + mesh_.HalfEdgesAt(h).size();
        front_.Cross(h, beam->origin, beam->interval,
                     [&](HalfEdge half_edge, const auto& origin,
                         const Interval& interval) {
                       sink_.Open(half_edge, number, origin, interval);
                     });
      }
      front_.targets().OfferWithin(segment.face(), number,
                                   [&](const PlanePoint& place) {
                                     return sigma + segment.DistanceTo(place);
                                   });
    }
    return faces;
  }

  Front& front_;
  const Mesh& mesh_;
  Sink& sink_;
};

// Starts from an anchor: relaxes the vertices around it and opens all that it
// sees of every edge. Sink: as for Expand; its Relax and Observe are the
// front's. Returns how many faces were looked at.
template <typename Front, typename Sink>
uint64_t AddAnchor(Front& front, const Anchor& anchor, Sink& sink) {
  return AnchorSeeding(front, sink).Add(anchor);
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_ANCHOR_SEEDING_H_
