#include "questions/isolines/face_ways.h"

#include <algorithm>
#include <cmath>

#include "surface/surface_location.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// Parallel rays that meet an edge at no larger angle run along it, but for
// rounding.
constexpr double kGrazing = 1e-9;

PlanePoint Turned(const PlanePoint& direction) {  // left, by a right angle
  return {-direction.y, direction.x};
}

}  // namespace

HalfPlane LeftOf(const PlanePoint& place, const PlanePoint& along) {
  const double length = std::hypot(along.x, along.y);
  const PlanePoint normal =
      Turned(PlanePoint{along.x / length, along.y / length});
  return {normal, Dot(normal, place)};
}

bool FaceWay::LeadsTo(const PlanePoint& place, double outside) const {
  return std::ranges::all_of(Bounds(), [&](const HalfPlane& bound) {
    return bound.Depth(place) >= -outside;
  });
}

double FaceWay::DistanceTo(const PlanePoint& place) const {
  return sigma + (is_segment ? Dot(from, place) : Norm(place - from));
}

FaceWays::FaceWays(const Mesh& mesh, uint32_t face)
    : mesh_(mesh), first_(mesh.FirstSide(face)) {
  const HalfEdgeFrame& frame = mesh.frame(first_);
  corners_ = {{{0, 0}, {frame.length, 0}, {frame.apex_x, frame.apex_y}}};
  directions_ = {
      {{1, 0}, {frame.right_x, frame.right_y}, {-frame.left_x, -frame.left_y}}};
  for (uint32_t side = 0; side < 3; ++side) {
    sides_[side] = LeftOf(corners_[side], directions_[side]);
    size_ = std::max(size_, mesh.frame(first_ + side).length);
  }
}

double FaceWays::height() const {
  return corners_[1].x * corners_[2].y / size_;
}

PlanePoint FaceWays::OnSide(uint32_t side, double along) const {
  return FromFrameOfSide(side, {along, 0});
}

PlanePoint FaceWays::FromFrameOfSide(uint32_t side,
                                     const PlanePoint& point) const {
  const PlanePoint turned = Product(directions_[side], point);
  return {corners_[side].x + turned.x, corners_[side].y + turned.y};
}

FacePoint FaceWays::PointAt(const PlanePoint& place) const {
  FacePoint point{.face = mesh_.FaceOf(first_)};
  double sum = 0;
  for (uint32_t corner = 0; corner < 3; ++corner) {
    const HalfPlane& opposite = sides_[(corner + 1) % 3];
    const double height = opposite.Depth(corners_[corner]);
    point.weights[corner] =
        std::max(opposite.Depth(place) / std::max(height, kLeastHeight),
                 10 * kLeastWeight);
    sum += point.weights[corner];
  }
  for (double& weight : point.weights) weight /= sum;
  return point;
}

void FaceWays::AddPoint(const PlanePoint& from, double sigma) {
  for (const FaceWay& way : ways_) {
    // Windows that abut end and begin at one place.
    if (!way.is_segment && way.bound_count == 0 &&
        way.sigma <= sigma * (1 + kAgreed) &&
        Norm(way.from - from) <= kRoundedPlace) {
      return;
    }
  }
  Add({.from = from, .sigma = sigma, .label = sigma});
}

void FaceWays::Add(FaceWay way) {
  for (const PlanePoint& corner : corners_) {
    way.farthest = std::max(way.farthest, way.DistanceTo(corner));
  }
  ways_.push_back(way);
}

bool FaceWays::IsCovered(const FaceWay& disc) const {
  // Windows that begin and end there: the one that leads farthest to the left,
  // and the one that leads farthest to the right.
  std::optional<PlanePoint> begin, end;
  // Where windows change over is known as well as their rays differ.
  const double same = kSameRay * size_;
  for (const FaceWay& way : ways_) {
    if (way.bound_count == 0) {
      if (way.DistanceTo(disc.from) < disc.sigma * (1 - kDominance)) {
        return true;
      }
      continue;
    }
    if (!way.LeadsTo(disc.from, same) ||
        way.DistanceTo(disc.from) > disc.sigma * (1 + kAlongEdge)) {
      continue;
    }
    const HalfPlane& left = way.bounds[0];
    const HalfPlane& right = way.bounds[1];
    const bool begins = left.Depth(disc.from) <= same;
    const bool ends = right.Depth(disc.from) <= same;
    if (!begins && !ends) return true;
    if (begins && !ends &&
        (!begin.has_value() || Cross(*begin, left.normal) > 0)) {
      begin = left.normal;
    }
    if (ends && !begins &&
        (!end.has_value() || Cross(*end, right.normal) < 0)) {
      end = right.normal;
    }
  }
  // All of the face may lie on their side of a ray.
  for (const std::optional<PlanePoint>& inside : {begin, end}) {
    if (inside.has_value() &&
        std::ranges::all_of(corners_, [&](const PlanePoint& corner) {
          return Dot(*inside, corner - disc.from) >= -same;
        })) {
      return true;
    }
  }
  return begin.has_value() && end.has_value() &&
         Cross(*end, *begin) <= kSameRay;
}

bool FaceWays::IsKnownToBeCovered(size_t disc) {
  std::optional<bool>& cover = covers_[disc];
  if (!cover.has_value()) cover = IsCovered(ways_[disc]);
  return *cover;
}

absl::StatusOr<std::optional<DirectionCone>> FaceWays::DirectionsAt(
    double level, const Neighbourhood& there, const Step& step) {
  absl::Status status = step(2 * ways_.size());
  if (!status.ok()) return status;
  covers_.resize(ways_.size());
  DirectionCone cone;
  for (const FaceWay& way : ways_) {
    if (way.bound_count == 0 || !way.MayHaveFront(level)) continue;
    if (std::ranges::any_of(way.Bounds(), [&](const HalfPlane& bound) {
          return std::max(bound.Depth(there.begin), bound.Depth(there.end)) <
                 -there.distance;
        })) {
      continue;
    }
    const PlanePoint& begin = way.bounds[0].normal;
    const PlanePoint& end = way.bounds[1].normal;
    if (!cone.Add(Turned(begin)) || !cone.Add({end.y, -end.x})) {
      return std::nullopt;
    }
  }
  for (size_t i = 0; i < ways_.size(); ++i) {
    const FaceWay& way = ways_[i];
    if (way.bound_count > 0 || !way.MayHaveFront(level)) continue;
    if (!covers_[i].has_value()) status = step(ways_.size());
    if (!status.ok()) return status;
    if (IsKnownToBeCovered(i)) continue;
    for (const PlanePoint& corner : corners_) {
      const PlanePoint ray = corner - way.from;
      if (Norm(ray) > kRoundedPlace && !cone.Add(ray)) return std::nullopt;
    }
  }
  return cone;
}

void FaceWays::AddThrough(HalfEdge h, const Way& way,
                          const std::array<double, 2>& at_ends) {
  const uint32_t entry = h % 3;
  const auto& [interval, origin] = way;
  FaceWay added{.is_segment = origin.is_segment,
                .sigma = origin.sigma,
                .label = way.Label()};
  if (origin.is_segment) {
    added.from = Product(directions_[entry], {origin.x, origin.depth});
    added.sigma -= Dot(added.from, corners_[entry]);
  } else {
    added.from = FromFrameOfSide(entry, {origin.x, -origin.depth});
  }
  const double length = mesh_.frame(h).length;
  for (const bool is_end : {false, true}) {
    const double at = is_end ? interval.end : interval.begin;
    const PlanePoint ray = {origin.is_segment ? origin.x : at - origin.x,
                            origin.depth};
    const double sign = is_end ? 1 : -1;
    added.AddBound(
        LeftOf(OnSide(entry, at),
               Product(directions_[entry], {sign * ray.x, sign * ray.y})));
    // Another end of the edge is reached by this way, or by a better one.
    const double sigma = origin.PathTo(at);
    const double to_corner = is_end ? length - at : at;
    if (at_ends[is_end ? 1 : 0] + to_corner <= sigma * (1 + kDominance)) {
      continue;
    }
    AddPoint(OnSide(entry, at), sigma);
  }
  // Rays that graze the edge bound nothing behind the place where they begin.
  if (added.is_segment && origin.depth < kGrazing) {
    added.AddBound({added.from, added.label - added.sigma});
  }
  Add(added);
}

void FaceWays::AddCorner(uint32_t corner, double sigma) {
  if (std::isfinite(sigma)) AddPoint(corners_[corner], sigma);
}

void FaceWays::AddWithin(const FacePoint& point, double sigma) {
  has_sources_ = true;
  AddPoint(InFrame(mesh_, point, first_), sigma);
}

void FaceWays::AddWithin(const CurveSegment& segment, double sigma) {
  const PlanePoint begin = InFrame(mesh_, segment.begin(), first_);
  const PlanePoint end = InFrame(mesh_, segment.end(), first_);
  const PlanePoint along = end - begin;
  const double length = std::hypot(along.x, along.y);
  if (!(length > 0)) return;
  has_sources_ = true;
  for (const double sign : {1.0, -1.0}) {
    const PlanePoint normal =
        Turned({sign * along.x / length, sign * along.y / length});
    FaceWay strip{.from = normal,
                  .is_segment = true,
                  .sigma = sigma - Dot(normal, begin),
                  .label = sigma};
    strip.AddBound({normal, Dot(normal, begin)});
    const PlanePoint unit = {along.x / length, along.y / length};
    strip.AddBound({unit, Dot(unit, begin)});
    strip.AddBound({{-unit.x, -unit.y}, -Dot(unit, end)});
    Add(strip);
  }
}

}  // namespace geodesic
