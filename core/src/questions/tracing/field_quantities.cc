#include "geodesic/field_quantities.h"

#include <cstdint>
#include <vector>

#include "absl/status/status.h"
#include "questions/tracing/straight_piece.h"
#include "questions/tracing/traced_field.h"
#include "solver/work_meter.h"
#include "surface/straight_line.h"
#include "surface/surface_location.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// The direction from an anchor to a vertex of a face around it.
Point DirectionFromAnchor(const Mesh& mesh, const Anchor& anchor, uint32_t v,
                          WorkMeter& meter) {
  Point direction{};
  VisitSharedFaces(mesh, anchor.begin, VertexPoint{v},
                   [&](const FacePoint&, const FacePoint& to) {
                     const HalfEdge h = mesh.FirstSide(to.face);
                     const PlanePoint b = InFrame(mesh, to, h);
                     const auto foot = FootOf(mesh, anchor, h, b);
                     if (!foot.has_value()) return !meter.Do();
                     direction =
                         DirectionInSpace(mesh, h, b - InFrame(mesh, *foot, h));
                     return true;
                   });
  return direction;
}

// The direction in which a straight piece arrives at its end, from its points.
Point DirectionOfPoints(const Mesh& mesh, const StraightPiece& piece,
                        uint32_t v) {
  const ScaledDifference difference(mesh.scale_exponent());
  Point to = mesh.positions()[v];
  for (const SurfacePoint& point : piece.points) {
    const Point from = PositionOf(point, mesh);
    const Vector stretch = difference(from, to);
    if (Norm(stretch) > kDirectionless * piece.length) {
      return Normalized(stretch);
    }
    to = from;
  }
  return {};
}

// The direction in which a path arrives at v from where its trace says; the
// zero vector if that is the same place.
absl::StatusOr<Point> DirectionOf(const TracedField& field, uint32_t v,
                                  WorkMeter& meter) {
  const Mesh& mesh = field.mesh();
  const auto& [pseudo_source, entry, x, depth] = field.VertexArrival(v);
  if (entry != kNoHalfEdge && mesh.IsCollapsed(entry)) {
    const absl::StatusOr<StraightPiece> piece =
        FollowBack(field, field.Vertex(v), meter);
    if (!piece.ok()) return piece.status();
    return DirectionOfPoints(mesh, *piece, v);
  }
  if (entry != kNoHalfEdge) {
    const auto place = WithinFace(mesh, VertexPoint{v}, mesh.FaceOf(entry));
    if (!place.has_value()) return Point{};
    if (!field.IsVertex(pseudo_source) &&
        field.AnchorOf(pseudo_source).is_segment) {
      return DirectionInSpace(mesh, entry, {x, depth});
    }
    const PlanePoint at = InFrame(mesh, *place, entry);
    return DirectionInSpace(mesh, entry, {at.x - x, at.y + depth});
  }
  if (field.IsVertex(pseudo_source)) {
    return DirectionBetween(mesh, pseudo_source, v);
  }
  return DirectionFromAnchor(mesh, field.AnchorOf(pseudo_source), v, meter);
}

}  // namespace

absl::StatusOr<std::vector<uint32_t>> NearestSources(const Mesh& mesh,
                                                     const ValidQuery& query,
                                                     const DistanceField& field,
                                                     Checkpoint& checkpoint) {
  absl::StatusOr<TracedField> traced = TracedField::Create(mesh, query, field);
  if (!traced.ok()) return traced.status();
  const auto poll = [&] { return checkpoint.Poll(ProgressOf(field)); };
  WorkMeter meter(poll);
  std::vector<uint32_t> labels(mesh.vertex_count(), kNoSource);
  std::vector<uint32_t> chain;
  for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    // From pseudo-source to pseudo-source, up to a label or an anchor.
    uint32_t at = v;
    chain.clear();
    while (traced->IsVertex(at) && labels[at] == kNoSource) {
      if (chain.size() == mesh.vertex_count()) {
        return absl::InternalError("the trace leads in circles");
      }
      if (!meter.Do()) return meter.status();
      chain.push_back(at);
      at = traced->VertexArrival(at).pseudo_source;
    }
    if (at == kNoPseudoSource) continue;
    const uint32_t label =
        traced->IsVertex(at) ? labels[at] : traced->AnchorOf(at).source;
    for (const uint32_t passed : chain) labels[passed] = label;
  }
  return labels;
}

absl::StatusOr<std::vector<Point>> Gradients(const Mesh& mesh,
                                             const ValidQuery& query,
                                             const DistanceField& field,
                                             Checkpoint& checkpoint) {
  absl::StatusOr<TracedField> traced = TracedField::Create(mesh, query, field);
  if (!traced.ok()) return traced.status();
  const auto poll = [&] { return checkpoint.Poll(ProgressOf(field)); };
  WorkMeter meter(poll);
  std::vector<Point> gradients(mesh.vertex_count());
  std::vector<bool> is_known(mesh.vertex_count());
  std::vector<uint32_t> chain;
  for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.Outgoing(v).empty()) continue;
    // Where vertices coincide a path arrives at the first of them.
    Point gradient{};
    chain.clear();
    for (uint32_t at = v; traced->IsVertex(at);) {
      if (is_known[at]) {
        gradient = gradients[at];
        break;
      }
      if (chain.size() == mesh.vertex_count()) {
        return absl::InternalError("the trace leads in circles");
      }
      if (!meter.Do()) return meter.status();
      chain.push_back(at);
      const uint32_t from = traced->VertexArrival(at).pseudo_source;
      if (from == kNoPseudoSource) break;
      const absl::StatusOr<Point> direction = DirectionOf(*traced, at, meter);
      if (!direction.ok()) return direction.status();
      gradient = *direction;
      if (gradient != Point{}) break;
      at = from;
    }
    for (const uint32_t passed : chain) {
      gradients[passed] = gradient;
      is_known[passed] = true;
    }
  }
  if (!meter.status().ok()) return meter.status();
  mesh.SpreadToJoined(gradients);
  return gradients;
}

absl::StatusOr<std::vector<uint32_t>> NearestSources(
    const Mesh& mesh, const ValidQuery& query, const DistanceField& field) {
  NoCheckpoint checkpoint;
  return NearestSources(mesh, query, field, checkpoint);
}

absl::StatusOr<std::vector<Point>> Gradients(const Mesh& mesh,
                                             const ValidQuery& query,
                                             const DistanceField& field) {
  NoCheckpoint checkpoint;
  return Gradients(mesh, query, field, checkpoint);
}

}  // namespace geodesic
