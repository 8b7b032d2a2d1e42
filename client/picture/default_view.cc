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

// How good a view is: the covered part of the screen, and more if the source is
// seen.
double Score(const MeshArrays& mesh, const std::vector<uint64_t>& sources,
             const View& view) {
  const Camera camera(mesh.positions, view, {0, 0, kTrialSize, kTrialSize});
  std::vector<Vector3> screen;
  screen.reserve(mesh.positions.size());
  for (const Point& point : mesh.positions) {
    screen.push_back(camera.Project(point));
  }
  const VisibilityBuffer buffer =
      Rasterize(screen, mesh.triangles, kTrialSize, kTrialSize);
  const auto covered =
      std::ranges::count_if(buffer.pixels, [](const VisibleSample& sample) {
        return sample.triangle != kNoTriangle;
      });
  double score = static_cast<double>(covered) / buffer.pixels.size();
  if (!sources.empty() && sources[0] < screen.size()) {
    const Vector3& source = screen[sources[0]];
    const int x = std::clamp(static_cast<int>(source.x), 0, kTrialSize - 1);
    const int y = std::clamp(static_cast<int>(source.y), 0, kTrialSize - 1);
    // Within two samples of the surface, which may slope.
    if (source.z + 2 >= buffer.At(x, y).depth) score += 0.25;
  }
  return score;
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

View ChooseView(const MeshArrays& mesh, const std::vector<uint64_t>& sources,
                UpAxis up) {
  // Flat meshes are looked at from above.
  const double elevation = up == UpAxis::kZ ? 45 : 18;
  View best = {up, 30, elevation};
  double best_score = -std::numeric_limits<double>::infinity();
  // In order of preference where scores are equal: the front first.
  for (const double azimuth :
       {30.0, -30.0, 60.0, -60.0, 150.0, -150.0, 120.0, -120.0}) {
    const View view = {up, azimuth, elevation};
    const double score = Score(mesh, sources, view);
    if (score > best_score + 1e-9) {
      best = view;
      best_score = score;
    }
  }
  return best;
}

}  // namespace geodesic::client
