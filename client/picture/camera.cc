#include "client/picture/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace geodesic::client {
namespace {

// The smallest interval that holds what has been added.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void Add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool empty() const { return low > high; }
  // Halved first: the ends may be the largest doubles of either sign.
  double middle() const { return low / 2 + high / 2; }
  double half() const { return high / 2 - low / 2; }
};

}  // namespace

Camera::Camera(const std::vector<Point>& points, const View& view,
               const Rectangle& area) {
  const double azimuth = view.azimuth * std::numbers::pi / 180;
  const double elevation = view.elevation * std::numbers::pi / 180;
  const double sin_a = std::sin(azimuth);
  const double cos_a = std::cos(azimuth);
  const double sin_e = std::sin(elevation);
  const double cos_e = std::cos(elevation);
  if (view.up == UpAxis::kY) {
    right_ = {cos_a, 0, -sin_a};
    up_ = {-sin_a * sin_e, cos_e, -cos_a * sin_e};
    toward_viewer_ = {sin_a * cos_e, sin_e, cos_a * cos_e};
  } else {
    right_ = {cos_a, sin_a, 0};
    up_ = {-sin_a * sin_e, cos_a * sin_e, cos_e};
    toward_viewer_ = {sin_a * cos_e, -cos_a * cos_e, sin_e};
  }

  Extent box[3];
  for (const Point& point : points) {
    for (int axis = 0; axis < 3; ++axis) box[axis].Add(point[axis]);
  }
  if (!box[0].empty()) {
    middle_ = {box[0].middle(), box[1].middle(), box[2].middle()};
    const double half = std::max({box[0].half(), box[1].half(), box[2].half()});
    if (half > 0) inverse_size_ = 1 / half;
  }

  // With scale 1 and center 0 Project gives the unscaled picture.
  Extent across, down;
  for (const Point& point : points) {
    const Vector3 screen = Project(point);
    across.Add(screen.x);
    down.Add(screen.y);
  }
  center_x_ = area.left + area.width / 2;
  center_y_ = area.top + area.height / 2;
  if (across.empty()) return;
  constexpr double kTiny = 1e-9;
  scale_ = 0.5 * std::min(area.width / std::max(across.half(), kTiny),
                          area.height / std::max(down.half(), kTiny));
  center_x_ -= scale_ * across.middle();
  center_y_ -= scale_ * down.middle();
}

Vector3 Camera::Project(const Point& point) const {
  const Vector3 scaled = {(point[0] - middle_.x) * inverse_size_,
                          (point[1] - middle_.y) * inverse_size_,
                          (point[2] - middle_.z) * inverse_size_};
  return {center_x_ + scale_ * Dot(scaled, right_),
          center_y_ - scale_ * Dot(scaled, up_),
          scale_ * Dot(scaled, toward_viewer_)};
}

}  // namespace geodesic::client
