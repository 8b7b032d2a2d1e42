#include "geodesic/log_map.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic/computation.h"
#include "geodesic_types/field_path.h"
#include "questions/tracing/straight_piece.h"
#include "questions/tracing/traced_field.h"
#include "solver/work_meter.h"
#include "surface/compass.h"

namespace geodesic {
namespace {

// The angles at which the shortest paths leave the source.
class Departures {
 public:
  Departures(const TracedField& field, const Compass& compass, WorkMeter& meter)
      : field_(field),
        compass_(compass),
        meter_(meter),
        source_(field.AnchorOf(field.mesh().vertex_count()).begin),
        angles_(field.mesh().vertex_count()) {}

  // REQUIRES: a path arrives at v.
  absl::StatusOr<double> AngleOf(uint32_t v) {
    // From vertex to vertex, up to one that is known or to the source.
    std::vector<uint32_t> passed;
    std::optional<double> angle;
    for (uint32_t at = v; !(angle = angles_[at]).has_value();) {
      if (passed.size() > field_.mesh().vertex_count()) {
        return absl::InternalError("the trace leads in circles");
      }
      passed.push_back(at);
      const absl::StatusOr<StraightPiece> piece =
          FollowBack(field_, field_.Vertex(at), meter_);
      if (!piece.ok()) return piece.status();
      if (IsSource(piece->start)) {
        angle = AngleAt(*piece, at);
        break;
      }
      at = piece->start;
    }
    for (const uint32_t at : passed) angles_[at] = angle;
    return *angle;
  }

 private:
  bool IsSource(uint32_t start) const {
    return !field_.IsVertex(start) ||
           source_ == SurfacePoint(VertexPoint{start});
  }
  // Of a piece from the source to vertex v.
  double AngleAt(const StraightPiece& piece, uint32_t v) const {
    if (piece.points.empty()) return 0;
    if (piece.frame == kNoHalfEdge) {
      // Along an edge that ends at v, or at a vertex that edges without length
      // join to v.
      const size_t points = piece.points.size();
      const auto* joined =
          points < 2 ? nullptr
                     : std::get_if<VertexPoint>(&piece.points[points - 2]);
      return compass_.AngleTowards(joined == nullptr ? v : joined->vertex);
    }
    return compass_.AngleOf(piece.frame, piece.direction);
  }

  const TracedField& field_;
  const Compass& compass_;
  WorkMeter& meter_;
  const SurfacePoint source_;
  std::vector<std::optional<double>> angles_;
};

}  // namespace

absl::StatusOr<LogMap> ComputeLogMap(const Mesh& mesh, const ValidQuery& query,
                                     const DistanceField& field, double radius,
                                     Checkpoint& checkpoint) {
  absl::Status status = CheckRadius(radius);
  if (!status.ok()) return status;
  absl::StatusOr<TracedField> traced = TracedField::Create(mesh, query, field);
  if (!traced.ok()) return traced.status();
  const std::vector<Source>& sources = query->sources;
  if (sources.size() != 1 || IsCurve(sources[0])) {
    return InvalidField("sources",
                        "sources: a log map has exactly one, which is a point");
  }
  const auto poll = [&] { return checkpoint.Poll(ProgressOf(field)); };
  WorkMeter meter(poll);
  absl::StatusOr<Compass> compass =
      Compass::At(mesh, std::get<SurfacePoint>(sources[0].place),
                  [&meter] { return meter.Do(); });
  if (!meter.status().ok()) return meter.status();
  if (!compass.ok()) return compass.status();
  LogMap map{.zero_direction = compass->zero_direction()};
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  Departures departures(*traced, *compass, meter);
  map.coordinates.reserve(mesh.vertex_count());
  for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (!meter.Do()) return meter.status();
    const double distance = field.distances[v] - sources[0].offset;
    map.coordinates.push_back({kNaN, kNaN});
    if (mesh.Outgoing(v).empty()) continue;
    if (field.distances[v] > radius) continue;
    if (distance == 0) map.coordinates.back() = {0, 0};
    if (!(distance > 0) || std::isinf(distance)) continue;
    const absl::StatusOr<double> angle = departures.AngleOf(v);
    if (!angle.ok()) return angle.status();
    map.coordinates.back() = {distance * std::cos(*angle),
                              distance * std::sin(*angle)};
  }
  mesh.SpreadToJoined(map.coordinates);
  return map;
}

absl::StatusOr<LogMap> ComputeLogMap(const Mesh& mesh, const ValidQuery& query,
                                     const DistanceField& field,
                                     double radius) {
  NoCheckpoint checkpoint;
  return ComputeLogMap(mesh, query, field, radius, checkpoint);
}

}  // namespace geodesic
