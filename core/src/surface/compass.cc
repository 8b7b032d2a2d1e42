#include "surface/compass.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <variant>

#include "absl/strings/str_cat.h"
#include "surface/straight_line.h"
#include "surface/surface_location.h"
#include "tolerances.h"

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

double DotInSpace(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

double AngleAt(const Mesh& mesh, HalfEdge h) {
  return std::atan2(mesh.frame(h).left_y, mesh.frame(h).left_x);
}

absl::StatusOr<Compass> Compass::At(const Mesh& mesh, const SurfacePoint& point,
                                    GoesOn goes_on) {
  Compass compass(mesh);
  compass.point_ = point;
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    absl::Status status = compass.GoAround(vertex->vertex, goes_on);
    if (!status.ok()) return status;
  } else if (const auto* edge = std::get_if<EdgePoint>(&point)) {
    // Both faces lie left of their half-edges; those are opposite.
    for (const HalfEdge h : SidesOf(mesh, edge->from, edge->to)) {
      if (mesh.IsIrregularEdge(h)) {
        return absl::InvalidArgumentError(
            absl::StrCat("source edge (", edge->from, ", ", edge->to,
                         "): the surface around it is not one oriented disk"));
      }
      compass.Add({h, mesh.From(h) == edge->from ? 0 : kPi, kPi});
    }
    std::ranges::sort(compass.sectors_, {}, &Sector::begin);
    compass.zero_direction_ = DirectionBetween(mesh, edge->from, edge->to);
  } else {
    const HalfEdge first = mesh.FirstSide(std::get<FacePoint>(point).face);
    compass.Add({first, 0, 2 * kPi});
    compass.zero_direction_ = DirectionInSpace(mesh, first, {1, 0});
  }
  return compass;
}

double Compass::AngleOf(HalfEdge h, const PlanePoint& direction) const {
  const auto found = of_face_.find(h / 3);
  if (found == of_face_.end()) return std::numeric_limits<double>::quiet_NaN();
  const Sector& sector = found->second;
  const double from_first =
      AngleInFace(mesh_, h) + std::atan2(direction.y, direction.x);
  const double within = std::remainder(
      from_first - AngleInFace(mesh_, sector.half_edge), 2 * kPi);
  return (sector.begin + within) * scale_;
}

double Compass::AngleTowards(uint32_t v) const {
  const auto spoke = spokes_.find(v);
  return spoke == spokes_.end() ? std::numeric_limits<double>::quiet_NaN()
                                : spoke->second * scale_;
}

void Compass::Add(const Sector& sector) {
  of_face_.emplace(sector.half_edge / 3, sector);
  sectors_.push_back(sector);
}

absl::Status Compass::GoAround(uint32_t vertex, GoesOn goes_on) {
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
    if (!goes_on()) return absl::CancelledError();
    if (h == outgoing[0]) zero_angle = angle;
    sectors.push_back({h, angle, AngleAt(mesh_, h)});
    angle += sectors.back().width;
    h = mesh_.Twin(Prev(h));
  } while (h != kNoHalfEdge && h != first);
  if (sectors.size() < outgoing.size()) {
    return absl::InvalidArgumentError(
        absl::StrCat("source vertex ", vertex,
                     ": the surface around it is not one oriented disk or "
                     "half-disk"));
  }
  for (Sector& sector : sectors) {
    if (!goes_on()) return absl::CancelledError();
    sector.begin -= zero_angle;
    Add(sector);
    spokes_.emplace(mesh_.To(sector.half_edge), sector.begin);
    spokes_.emplace(mesh_.Apex(sector.half_edge), sector.begin + sector.width);
  }
  if (h == first) scale_ = 2 * kPi / angle;
  return absl::OkStatus();
}

absl::StatusOr<Heading> Compass::At(double angle) const {
  const double begin = sectors_.front().begin;
  const double end = sectors_.back().begin + sectors_.back().width;
  // Unscaled. At a boundary there may be less or more than a turn.
  const double turn = 2 * kPi / scale_;
  double at = angle / scale_;
  if (!(at >= begin && at <= end)) {
    at -= std::floor((at - begin) / turn) * turn;
    if (at - turn >= begin - kRoundedAngle) at -= turn;
  }
  if (!(at <= end + kRoundedAngle)) {
    return absl::InvalidArgumentError(
        absl::StrCat("the angle ", angle, " leads out of the surface"));
  }
  const auto next = std::ranges::upper_bound(sectors_, std::max(at, begin), {},
                                             &Sector::begin);
  const Sector& sector = *std::prev(next);
  return In(sector, std::clamp(at - sector.begin, 0.0, sector.width));
}

absl::StatusOr<Heading> Compass::Along(const Point& vector,
                                       GoesOn goes_on) const {
  const Point towards = Normalized(vector);
  std::optional<Heading> best;
  double most = 0;
  for (const Sector& sector : sectors_) {
    if (!goes_on()) return absl::CancelledError();
    const Point along = DirectionInSpace(mesh_, sector.half_edge, {1, 0});
    const Point up = DirectionInSpace(mesh_, sector.half_edge, {0, 1});
    const PlanePoint projected = {DotInSpace(towards, along),
                                  DotInSpace(towards, up)};
    double within = std::atan2(projected.y, projected.x);
    if (within < 0) within += 2 * kPi;
    if (within > sector.width) {
      // One of the sector's sides is nearer.
      within = within - sector.width < 2 * kPi - within ? sector.width : 0;
    }
    const double cosine =
        projected.x * std::cos(within) + projected.y * std::sin(within);
    if (!(cosine > most)) continue;
    most = cosine;
    best = In(sector, within);
  }
  if (most > kRoundedAngle) return *best;
  return absl::InvalidArgumentError(
      "the direction is at right angles to the surface, or leads away from it");
}

Heading Compass::In(const Sector& sector, double within) const {
  Heading heading{.half_edge = sector.half_edge,
                  .place = {},
                  .direction = {std::cos(within), std::sin(within)}};
  const FacePoint at =
      *WithinFace(mesh_, point_, mesh_.FaceOf(sector.half_edge));
  heading.place = InFrame(mesh_, at, sector.half_edge);
  return heading;
}

}  // namespace geodesic
