#include "geodesic/log_map.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic_types/field_path.h"
#include "questions/paths/straight_piece.h"
#include "questions/paths/traced_field.h"
#include "solver/work_meter.h"
#include "surface/straight_line.h"

namespace geodesic {
namespace {

constexpr double kPi = std::numbers::pi;

// The direction of a half-edge as an angle in the frame of its face's first
// one.
double AngleInFace(const Mesh& mesh, HalfEdge h) {
  const HalfEdgeFrame& first = mesh.frame(h - h % 3);
  switch (h % 3) {
    case 0:
      return 0;
    case 1:
      return std::atan2(first.right_y, first.right_x);
    default:
      return std::atan2(-first.left_y, -first.left_x);
  }
}

// Angles around a source point. Around it lie sectors, each a corner, a half or
// the whole of a face; a sector begins at a half-edge that leaves the point or
// runs along it.
class Compass {
 public:
  static absl::StatusOr<Compass> At(const Mesh& mesh,
                                    const SurfacePoint& point) {
    Compass compass(mesh);
    if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
      if (absl::Status status = compass.GoAround(vertex->vertex);
          !status.ok()) {
        return status;
      }
    } else if (const auto* edge = std::get_if<EdgePoint>(&point)) {
      // Both faces lie left of their half-edges; those are opposite.
      for (const HalfEdge h : SidesOf(mesh, edge->from, edge->to)) {
        if (mesh.IsIrregularEdge(h)) {
          return absl::InvalidArgumentError(absl::StrCat(
              "source edge (", edge->from, ", ", edge->to,
              "): the surface around it is not one oriented disk"));
        }
        compass.Add({h, mesh.From(h) == edge->from ? 0 : kPi});
      }
      compass.zero_direction_ = DirectionBetween(mesh, edge->from, edge->to);
    } else {
      const HalfEdge first = mesh.FirstSide(std::get<FacePoint>(point).face);
      compass.Add({first, 0});
      compass.zero_direction_ = DirectionInSpace(mesh, first, {1, 0});
    }
    return compass;
  }

  // Unit vector in space of angle 0.
  const Point& zero_direction() const { return zero_direction_; }

  // The angle of a direction in the frame of h, whose face lies around the
  // point.
  double AngleOf(HalfEdge h, const PlanePoint& direction) const {
    const auto sector = sectors_.find(h / 3);
    if (sector == sectors_.end()) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    const auto& [half_edge, begin] = sector->second;
    const double from_first =
        AngleInFace(mesh_, h) + std::atan2(direction.y, direction.x);
    const double within =
        std::remainder(from_first - AngleInFace(mesh_, half_edge), 2 * kPi);
    return (begin + within) * scale_;
  }
  // The angle of the edge to vertex v. REQUIRES: the point is a vertex.
  double AngleTowards(uint32_t v) const {
    const auto spoke = spokes_.find(v);
    return spoke == spokes_.end() ? std::numeric_limits<double>::quiet_NaN()
                                  : spoke->second * scale_;
  }

 private:
  struct Sector {
    HalfEdge half_edge;
    double begin;
  };

  explicit Compass(const Mesh& mesh) : mesh_(mesh) {}

  void Add(const Sector& sector) {
    sectors_.emplace(sector.half_edge / 3, sector);
  }

  absl::Status GoAround(uint32_t vertex) {
    const std::span<const HalfEdge> outgoing = mesh_.Outgoing(vertex);
    if (outgoing.empty()) {
      return absl::InvalidArgumentError(
          absl::StrCat("source vertex ", vertex,
                       " belongs to no face, so that no path leaves it; name a "
                       "point of a face"));
    }
    zero_direction_ = DirectionInSpace(mesh_, outgoing[0], {1, 0});
    HalfEdge first = outgoing[0];
    for (const HalfEdge h : outgoing) {
      if (mesh_.Twin(h) == kNoHalfEdge) first = h;
    }
    std::vector<Sector> sectors;
    double angle = 0, zero_angle = 0;
    HalfEdge h = first;
    do {
      if (h == outgoing[0]) zero_angle = angle;
      sectors.push_back({h, angle});
      angle += AngleAt(h);
      h = mesh_.Twin(Prev(h));
    } while (h != kNoHalfEdge && h != first);
    if (sectors.size() < outgoing.size()) {
      return absl::InvalidArgumentError(
          absl::StrCat("source vertex ", vertex,
                       ": the surface around it is not one oriented disk or "
                       "half-disk"));
    }
    for (Sector& sector : sectors) {
      sector.begin -= zero_angle;
      Add(sector);
      spokes_.emplace(mesh_.To(sector.half_edge), sector.begin);
      spokes_.emplace(mesh_.Apex(sector.half_edge),
                      sector.begin + AngleAt(sector.half_edge));
    }
    if (h == first) scale_ = 2 * kPi / angle;
    return absl::OkStatus();
  }

  // Of the face's corner at the start of h.
  double AngleAt(HalfEdge h) const {
    return std::atan2(mesh_.frame(h).left_y, mesh_.frame(h).left_x);
  }

  const Mesh& mesh_;
  absl::flat_hash_map<uint32_t, Sector> sectors_;  // by h / 3 of their faces
  // Of a vertex, where its edges begin, by their other ends.
  absl::flat_hash_map<uint32_t, double> spokes_;
  Point zero_direction_{};
  double scale_ = 1;
};

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
  if (!(radius >= 0)) {
    return InvalidField(
        "radius", absl::StrCat("radius ", radius, " is not a number >= 0"));
  }
  absl::StatusOr<TracedField> traced = TracedField::Create(mesh, query, field);
  if (!traced.ok()) return traced.status();
  const std::vector<Source>& sources = query->sources;
  if (sources.size() != 1 || IsCurve(sources[0])) {
    return InvalidField("sources",
                        "sources: a log map has exactly one, which is a point");
  }
  absl::StatusOr<Compass> compass =
      Compass::At(mesh, std::get<SurfacePoint>(sources[0].place));
  if (!compass.ok()) return compass.status();
  LogMap map{.zero_direction = compass->zero_direction()};
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const auto poll = [&] { return checkpoint.Poll(ProgressOf(field)); };
  WorkMeter meter(poll);
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
