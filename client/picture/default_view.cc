#include "client/picture/default_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "client/picture/rasterizer.h"

namespace geodesic::client {
namespace {

// The screen on which views are tried.
constexpr int kTrialSize = 192;

std::array<double, 3> BoxSides(const std::vector<Point>& positions) {
  std::array<double, 3> sides = {};
  for (int axis = 0; axis < 3 && !positions.empty(); ++axis) {
    const auto [low, high] = std::ranges::minmax(
        positions, {}, [axis](const Point& point) { return point[axis]; });
    sides[axis] = high[axis] / 2 - low[axis] / 2;
  }
  return sides;
}

// What a view shows.
struct Trial {
  View view;
  // How much of the mesh's outline fills, in units of the mesh: not of the
  // screen, where a long mesh seen from its end looks large.
  double area = 0;
  // The fraction of the marks that is seen.
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
  // A mark within two samples of the surface, which may slope, is seen.
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
  if (positions.empty()) return false;
  const auto [low, high] = std::ranges::minmax(
      positions, {}, [up](const Point& point) { return point[up]; });
  const double ground = low[up] + 0.03 * (high[up] - low[up]);
  for (const int axis : {(up + 1) % 3, (up + 2) % 3}) {
    double middle = 0;
    double from = std::numeric_limits<double>::infinity();
    double to = -from;
    for (const Point& point : positions) {
      middle += point[axis] / static_cast<double>(positions.size());
      if (point[up] > ground) continue;
      from = std::min(from, point[axis]);
      to = std::max(to, point[axis]);
    }
    if (middle < from || middle > to) return false;
  }
  return true;
}

}  // namespace

UpAxis GuessUpAxis(const std::vector<Point>& positions) {
  const std::array<double, 3> sides = BoxSides(positions);
  const bool is_flat = sides[2] < 0.4 * std::min(sides[0], sides[1]);
  return is_flat || (StandsOn(2, positions) && !StandsOn(1, positions))
             ? UpAxis::kZ
             : UpAxis::kY;
}

View ChooseView(const MeshArrays& mesh, const std::vector<Point>& shown,
                const std::vector<Point>& marks, UpAxis up) {
  // Flat meshes are looked at from above.
  const double elevation = up == UpAxis::kZ ? 45 : 18;
  std::vector<Trial> trials;
  double largest_area = 0;
  // In order of preference where views are equally good: the front first.
  for (const double azimuth :
       {30.0, -30.0, 60.0, -60.0, 150.0, -150.0, 120.0, -120.0}) {
    trials.push_back(Try(mesh, shown, marks, {up, azimuth, elevation}));
    largest_area = std::max(largest_area, trials.back().area);
  }
  const auto score = [largest_area](const Trial& trial) {
    // Steps of a hundredth, so that noise does not overrule the order.
    const double area =
        largest_area > 0 ? std::round(100 * trial.area / largest_area) : 0;
    return area + 35 * trial.marks_seen;
  };
  return std::ranges::max_element(trials, {}, score)->view;
}

}  // namespace geodesic::client
