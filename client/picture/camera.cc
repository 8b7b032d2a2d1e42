#include "client/picture/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "client/picture/rasterizer.h"

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
  // Both ends are halved first, since they may be the largest doubles.
  double middle() const { return low / 2 + high / 2; }
  double half() const { return high / 2 - low / 2; }
};

std::array<Extent, 3> BoxOf(const std::vector<Point>& points) {
  std::array<Extent, 3> box;
  for (const Point& point : points) {
    for (size_t axis = 0; axis < box.size(); ++axis) box[axis].Add(point[axis]);
  }
  return box;
}

// The screen on which views are tried.
constexpr int kTrialSize = 192;

// A view and how much it shows.
struct Trial {
  View view;
  // Area of the mesh's outline in units of the mesh. In units of the screen a
  // long mesh would look large from its end.
  double area = 0;
  // The fraction of the marks that is visible.
  double marks_seen = 0;
};

Trial Try(const MeshArrays& mesh, const std::vector<Point>& shown,
          const std::vector<Point>& marks, const View& view) {
  const Camera camera(shown, view, {0, 0, kTrialSize, kTrialSize});
  std::vector<Vector3> screen;
  screen.reserve(mesh.positions.size());
  for (const Point& point : mesh.positions) {
    screen.push_back(camera.Project(point));
  }
  const VisibilityBuffer buffer =
      Rasterize(screen, mesh.triangles, kTrialSize, kTrialSize);
  const auto covered =
      std::ranges::count_if(buffer.samples, [](const VisibleSample& sample) {
        return sample.triangle != kNoTriangle;
      });
  Trial trial = {
      .view = view,
      .area = static_cast<double>(covered) / (camera.scale() * camera.scale())};
  // A mark may be two samples behind the surface, which may slope.
  const auto seen = std::ranges::count_if(marks, [&](const Point& mark) {
    return IsVisible(camera.Project(mark), 2, buffer);
  });
  if (!marks.empty()) {
    trial.marks_seen =
        static_cast<double>(seen) / static_cast<double>(marks.size());
  }
  return trial;
}

// Whether the mesh would stand upright on the plane below it: its middle is
// above the box around the points that touch the plane.
bool StandsOn(int up, const std::vector<Point>& positions) {
  const std::array<Extent, 3> box = BoxOf(positions);
  const double ground = box[up].low + 0.03 * (box[up].high - box[up].low);
  for (const int axis : {(up + 1) % 3, (up + 2) % 3}) {
    double middle = 0;
    Extent base;
    for (const Point& point : positions) {
      middle += point[axis] / static_cast<double>(positions.size());
      if (point[up] <= ground) base.Add(point[axis]);
    }
    if (!(middle >= base.low && middle <= base.high)) return false;
  }
  return true;
}

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

  const std::array<Extent, 3> box = BoxOf(points);
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

UpAxis GuessUpAxis(const std::vector<Point>& positions) {
  const std::array<Extent, 3> box = BoxOf(positions);
  const bool is_flat =
      box[2].half() < 0.4 * std::min(box[0].half(), box[1].half());
  return is_flat || (StandsOn(2, positions) && !StandsOn(1, positions))
             ? UpAxis::kZ
             : UpAxis::kY;
}

View ChooseView(const MeshArrays& mesh, const std::vector<Point>& shown,
                const std::vector<Point>& marks, UpAxis up) {
  // Flat meshes are seen from above.
  const double elevation = up == UpAxis::kZ ? 45 : 18;
  std::vector<Trial> trials;
  double largest_area = 0;
  // Of equally good views the first wins, so views of the front come first.
  for (const double azimuth :
       {30.0, -30.0, 60.0, -60.0, 150.0, -150.0, 120.0, -120.0}) {
    trials.push_back(Try(mesh, shown, marks, {up, azimuth, elevation}));
    largest_area = std::max(largest_area, trials.back().area);
  }
  const auto score = [largest_area](const Trial& trial) {
    // The area is rounded to hundredths, so noise does not overrule the order.
    const double area =
        largest_area > 0 ? std::round(100 * trial.area / largest_area) : 0;
    return area + 35 * trial.marks_seen;
  };
  return std::ranges::max_element(trials, {}, score)->view;
}

}  // namespace geodesic::client
