#include "questions/tracing/path_tracer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic/path.h"
#include "questions/tracing/straight_piece.h"
#include "questions/tracing/traced_field.h"
#include "surface/surface_location.h"

namespace geodesic {
namespace {

absl::Status OutOfRange(const char* name, uint32_t number, const char* owner,
                        size_t count, const char* what) {
  return absl::InvalidArgumentError(
      absl::StrCat(name, " ", number, " is out of range: the ", owner, " has ",
                   count, " ", what, ", numbered from 0"));
}

// As NamedIn, in any face that holds the point.
SurfacePoint NamedAnywhere(const SurfacePoint& point, const Mesh& mesh) {
  return std::holds_alternative<EdgePoint>(point)
             ? NamedIn(FirstFaceAround(mesh, point).face, point, mesh)
             : point;
}

}  // namespace

uint64_t BytesOf(std::span<const GeodesicPath> paths) {
  uint64_t bytes = paths.size_bytes();
  for (const GeodesicPath& path : paths) {
    bytes += path.points.capacity() * sizeof(SurfacePoint) +
             path.positions.capacity() * sizeof(Point);
  }
  return bytes;
}

absl::StatusOr<GeodesicPath> TracePath(const TracedField& field, PathEnd end,
                                       double distance, WorkMeter& meter) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (end.arrival.pseudo_source == kNoPseudoSource) {
    return GeodesicPath{.distance = kInfinity, .length = kInfinity};
  }
  GeodesicPath path{.distance = distance};
  path.points.push_back(NamedAnywhere(end.point, field.mesh()));
  // From one vertex to a nearer one: no vertex comes twice.
  for (uint32_t pieces = 0; pieces <= field.mesh().vertex_count(); ++pieces) {
    absl::StatusOr<StraightPiece> piece = FollowBack(field, end, meter);
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
    path.positions.reserve(path.points.size());
    for (const SurfacePoint& point : path.points) {
      if (!meter.Do()) return meter.status();
      path.positions.push_back(PositionOf(point, field.mesh()));
    }
    return path;
  }
  return absl::InternalError("the trace leads in circles");
}

PathTracer::PathTracer(std::unique_ptr<const TracedField> field,
                       const Progress& progress)
    : field_(std::move(field)), progress_(progress) {}
PathTracer::PathTracer(PathTracer&&) noexcept = default;
PathTracer& PathTracer::operator=(PathTracer&&) noexcept = default;
PathTracer::~PathTracer() = default;

absl::StatusOr<PathTracer> PathTracer::Create(const Mesh& mesh,
                                              const ValidQuery& query,
                                              const DistanceField& field) {
  absl::StatusOr<TracedField> traced = TracedField::Create(mesh, query, field);
  if (!traced.ok()) return traced.status();
  return PathTracer(std::make_unique<TracedField>(*std::move(traced)),
                    ProgressOf(field));
}

absl::StatusOr<GeodesicPath> PathTracer::ToVertex(
    uint32_t vertex, Checkpoint& checkpoint) const {
  const uint32_t count = field_->mesh().vertex_count();
  if (vertex >= count) {
    return OutOfRange("vertex", vertex, "mesh", count, "vertices");
  }
  return Trace(field_->Vertex(field_->mesh().JoinedInto(vertex)),
               field_->distances().vertices[vertex], checkpoint);
}

absl::StatusOr<GeodesicPath> PathTracer::ToTarget(
    uint32_t target, Checkpoint& checkpoint) const {
  const size_t count = field_->targets().size();
  if (target >= count) {
    return OutOfRange("target", target, "query", count, "targets");
  }
  return Trace(field_->Target(target), field_->distances().targets[target],
               checkpoint);
}

absl::StatusOr<GeodesicPath> PathTracer::ToVertex(uint32_t vertex) const {
  NoCheckpoint checkpoint;
  return ToVertex(vertex, checkpoint);
}

absl::StatusOr<GeodesicPath> PathTracer::ToTarget(uint32_t target) const {
  NoCheckpoint checkpoint;
  return ToTarget(target, checkpoint);
}

absl::StatusOr<GeodesicPath> PathTracer::Trace(const PathEnd& end,
                                               double distance,
                                               Checkpoint& checkpoint) const {
  const auto poll = [&] { return checkpoint.Poll(progress_); };
  WorkMeter meter(poll);
  return TracePath(*field_, end, distance, meter);
}

}  // namespace geodesic
