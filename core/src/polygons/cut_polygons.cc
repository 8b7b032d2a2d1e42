#include "polygons/cut_polygons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "polygons/covers_once.h"
#include "polygons/ears.h"
#include "polygons/flat_polygon.h"
#include "polygons/pace.h"
#include "tolerances.h"

namespace geodesic {
namespace {

using Vector = std::array<double, 3>;

Vector Cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}
double Norm(const Vector& a) {
  return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

bool IsUpward(const Flat& way) {
  return way.y > 0 || (way.y == 0 && way.x > 0);
}

// Whether the polygon goes round once, never turning right, nor back.
bool IsConvex(const FlatPolygon& polygon, Pace& pace) {
  // Several corners may be at one place.
  const auto is_no_way = [](const Flat& way) {
    return Dot(way, way) <= kStraightCorner * kStraightCorner;
  };
  Flat last = polygon.At(0);
  Flat way;
  for (uint32_t corner = polygon.size() - 1; corner > 0 && is_no_way(way);
       --corner) {
    way = last - polygon.At(corner);
    if (!pace.Goes()) return false;
  }
  int rounds = 0;
  for (uint32_t corner = 1; corner <= polygon.size(); ++corner) {
    if (!pace.Goes()) return false;
    const Flat at = polygon.At(corner == polygon.size() ? 0 : corner);
    const Flat next_way = at - last;
    if (is_no_way(next_way)) continue;
    const double turn = Turn(way, next_way);
    if (turn < 0 || (turn == 0 && Dot(way, next_way) < 0)) return false;
    if (IsUpward(way) != IsUpward(next_way)) {
      // To the left past the axis of x, or a rounding to the right.
      const bool is_left = Turn(way, next_way, 0) >= 0;
      if (is_left == IsUpward(next_way)) rounds += is_left ? 1 : -1;
    }
    way = next_way;
    last = at;
  }
  return rounds == 1;
}

class PolygonCutter {
 public:
  explicit PolygonCutter(const std::vector<Point>& positions, Pace& pace)
      : positions_(positions.data()), pace_(pace) {}

  // False if the polygon of a fan crosses itself or cannot be cut.
  bool Cut(std::span<Triangle> fan) {
    if (!Unfold(fan) || !Measure()) return true;
    const double length = Norm(normal_);
    // A rounding of each side may have made this area.
    if (length <= kStraightCorner * perimeter_) return IsInLine();
    for (double& part : normal_) part /= length;
    const FlatPolygon polygon(positions_, corners_, unit_, normal_);
    if (IsConvex(polygon, pace_) || IsInLine()) return true;
    const size_t triangles = corners_.size() - 2;
    if (!CoversOnce(polygon, pace_) ||
        !CutEars(polygon, pace_, fan.first(triangles))) {
      return false;
    }
    // Corners that came twice in a row.
    for (Triangle& triangle : fan.subspan(triangles)) {
      triangle = {corners_[0], corners_[1], corners_[1]};
    }
    return true;
  }

 private:
  // Takes the corners from a fan, but those that come again at once; whether
  // there are enough to be cut.
  bool Unfold(std::span<const Triangle> fan) {
    corners_.clear();
    corners_.reserve(fan.size() + 2);
    corners_.push_back(fan[0][0]);
    const auto add = [this](uint32_t corner) {
      if (corner != corners_.back()) corners_.push_back(corner);
    };
    add(fan[0][1]);
    for (const Triangle& triangle : fan) {
      add(triangle[2]);
      if (!pace_.Goes()) return false;
    }
    while (corners_.size() > 1 && corners_.front() == corners_.back()) {
      corners_.pop_back();
    }
    return corners_.size() > 3;
  }

  // Finds unit, normal and perimeter; false if there is none, as where a
  // coordinate is not finite.
  bool Measure() {
    double largest = 0;
    for (const uint32_t corner : corners_) {
      for (const double coordinate : positions_[corner]) {
        if (!std::isfinite(coordinate)) return false;
        largest = std::max(largest, std::abs(coordinate));
      }
      if (!pace_.Goes()) return false;
    }
    if (largest == 0) return false;
    // A power of two, so that nothing is rounded.
    unit_ = std::ldexp(1.0,
                       std::min(-std::ilogb(largest),
                                std::numeric_limits<double>::max_exponent - 1));
    // Newell's: the sum of the triangles' from any point, here the first
    // corner.
    normal_ = {};
    perimeter_ = 0;
    Vector way = FromFirst(corners_.back());
    for (const uint32_t corner : corners_) {
      const Vector next = FromFirst(corner);
      const Vector turn = Cross(way, next);
      for (int axis = 0; axis < 3; ++axis) normal_[axis] += turn[axis];
      perimeter_ +=
          Norm({next[0] - way[0], next[1] - way[1], next[2] - way[2]});
      way = next;
      if (!pace_.Goes()) return false;
    }
    return true;
  }

  Vector FromFirst(uint32_t vertex) const {
    const Point& first = positions_[corners_[0]];
    const Point& point = positions_[vertex];
    return {point[0] * unit_ - first[0] * unit_,
            point[1] * unit_ - first[1] * unit_,
            point[2] * unit_ - first[2] * unit_};
  }

  // Whether all corners lie on a line.
  bool IsInLine() const {
    Vector farthest = {};
    for (const uint32_t corner : corners_) {
      const Vector way = FromFirst(corner);
      if (Norm(way) > Norm(farthest)) farthest = way;
      if (!pace_.Goes()) return true;
    }
    const double reach = Norm(farthest);
    for (const uint32_t corner : corners_) {
      if (Norm(Cross(farthest, FromFirst(corner))) > kStraightCorner * reach) {
        return false;
      }
      if (!pace_.Goes()) return true;
    }
    return true;
  }

  const Point* const positions_;
  Pace& pace_;
  // Of the polygon at hand; coordinates times `unit_` are below 2.
  std::vector<uint32_t> corners_;
  double unit_ = 1;
  double perimeter_ = 0;
  Vector normal_ = {};
};

}  // namespace

absl::Status CutPolygons(const std::vector<bool>& is_joined,
                         Checkpoint* checkpoint, TriangleSoup& soup) {
  Pace pace(checkpoint);
  PolygonCutter cutter(soup.positions, pace);
  uint64_t joints = 0;
  for (size_t end = 1; end < is_joined.size(); ++end) {
    if (!pace.Goes()) return pace.status();
    if (!is_joined[end]) continue;
    const size_t begin = end - 1;
    // Each triangle that was joined is one polygon less.
    const uint64_t polygon = begin - joints;
    while (end < is_joined.size() && is_joined[end]) ++end;
    joints += end - begin - 1;
    const bool is_cut =
        cutter.Cut(std::span(soup.triangles).subspan(begin, end - begin));
    if (!pace.status().ok()) return pace.status();
    if (is_cut) continue;
    if (soup.reading.crossing_polygons == 0)
      soup.reading.first_crossing_polygon = polygon;
    ++soup.reading.crossing_polygons;
  }
  return absl::OkStatus();
}

}  // namespace geodesic
