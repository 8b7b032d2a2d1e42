#include "questions/paths/path_tracer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic/path.h"
#include "questions/paths/straight_piece.h"
#include "questions/paths/traced_field.h"

namespace geodesic {
namespace {

absl::Status OutOfRange(const char* name, uint32_t number, const char* owner,
                        size_t count, const char* what) {
  return absl::InvalidArgumentError(
      absl::StrCat(name, " ", number, " is out of range: the ", owner, " has ",
                   count, " ", what, ", numbered from 0"));
}

}  // namespace

absl::StatusOr<GeodesicPath> TracePath(const TracedField& field, PathEnd end,
                                       double distance) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (end.arrival.pseudo_source == kNoPseudoSource) {
    return GeodesicPath{.distance = kInfinity, .length = kInfinity};
  }
  GeodesicPath path{.distance = distance};
  path.points.push_back(end.point);
  // From one vertex to a nearer one: no vertex comes twice.
  for (uint32_t pieces = 0; pieces <= field.mesh().vertex_count(); ++pieces) {
    absl::StatusOr<StraightPiece> piece = FollowBack(field, end);
    if (!piece.ok()) return piece.status();
    path.points.insert(path.points.end(), piece->points.begin(),
                       piece->points.end());
    if (field.IsVertex(piece->start)) {
      end = field.Vertex(piece->start);
      continue;
    }
    const Anchor& anchor = field.AnchorOf(piece->start);
    path.source = anchor.source;
    path.length = std::max(distance - anchor.offset, 0.0);
    std::ranges::reverse(path.points);
    for (const SurfacePoint& point : path.points) {
      path.positions.push_back(PositionOf(point, field.mesh()));
    }
    return path;
  }
  return absl::InternalError("the trace leads in circles");
}

PathTracer::PathTracer(std::unique_ptr<const TracedField> field)
    : field_(std::move(field)) {}
PathTracer::PathTracer(PathTracer&&) noexcept = default;
PathTracer& PathTracer::operator=(PathTracer&&) noexcept = default;
PathTracer::~PathTracer() = default;

absl::StatusOr<PathTracer> PathTracer::Create(const Mesh& mesh,
                                              const ValidQuery& query,
                                              const DistanceField& field) {
  absl::StatusOr<TracedField> traced = TracedField::Create(mesh, query, field);
  if (!traced.ok()) return traced.status();
  return PathTracer(std::make_unique<TracedField>(*std::move(traced)));
}

absl::StatusOr<GeodesicPath> PathTracer::ToVertex(uint32_t vertex) const {
  const uint32_t count = field_->mesh().vertex_count();
  if (vertex >= count) {
    return OutOfRange("vertex", vertex, "mesh", count, "vertices");
  }
  return TracePath(*field_, field_->Vertex(vertex),
                   field_->distances().vertices[vertex]);
}

absl::StatusOr<GeodesicPath> PathTracer::ToTarget(uint32_t target) const {
  const size_t count = field_->targets().size();
  if (target >= count) {
    return OutOfRange("target", target, "query", count, "targets");
  }
  return TracePath(*field_, field_->Target(target),
                   field_->distances().targets[target]);
}

}  // namespace geodesic
