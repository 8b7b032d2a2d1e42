#include "client/picture/picture.h"

#include <algorithm>
#include <cmath>

#include "client/picture/default_view.h"
#include "client/picture/isolines.h"
#include "client/picture/key.h"
#include "client/picture/overlay.h"
#include "client/picture/rasterizer.h"
#include "client/picture/surface.h"

namespace geodesic::client {
namespace {

constexpr LinearColor kThinLine = {0.012F, 0.012F, 0.02F};
constexpr LinearColor kBoldLine = {0.75F, 0.02F, 0.02F};
constexpr LinearColor kRim = {1, 1, 1};
constexpr LinearColor kSourceMark = {0.75F, 0.02F, 0.02F};
constexpr LinearColor kTargetMark = {0.02F, 0.12F, 0.6F};

// In samples.
std::vector<Vector3> OnScreen(const std::vector<Point>& points,
                              const Camera& camera) {
  std::vector<Vector3> screen;
  screen.reserve(points.size());
  for (const Point& point : points) {
    screen.push_back(kSamples * camera.Project(point));
  }
  return screen;
}

std::vector<ScreenLine> OnScreen(const std::vector<PictureLine>& lines,
                                 const Camera& camera) {
  std::vector<ScreenLine> screen;
  for (const PictureLine& line : lines) {
    screen.push_back(OnScreen(line.points, camera));
    if (line.is_closed && !line.points.empty()) {
      screen.back().push_back(screen.back()[0]);
    }
  }
  return screen;
}

double LargestFinite(std::span<const double> distances) {
  double largest = 0;
  for (const double distance : distances) {
    if (std::isfinite(distance)) largest = std::max(largest, distance);
  }
  return largest;
}

// What a view should show besides the mesh: dots, and points along lines.
std::vector<Point> Marks(const PictureContent& content) {
  constexpr size_t kPerLine = 50;
  std::vector<Point> marks;
  if (!content.sources.empty()) marks.push_back(content.sources[0]);
  for (const Point& target : content.targets) marks.push_back(target);
  for (const PictureLine& line : content.bold_lines) {
    const size_t step = 1 + line.points.size() / kPerLine;
    for (size_t i = 0; i < line.points.size(); i += step) {
      marks.push_back(line.points[i]);
    }
  }
  return marks;
}

// The vertices that are corners: stray ones do not decide what is shown.
std::vector<Point> Corners(const MeshArrays& mesh) {
  std::vector<bool> used(mesh.positions.size(), false);
  for (const Triangle& triangle : mesh.triangles) {
    for (const uint32_t vertex : triangle) used[vertex] = true;
  }
  std::vector<Point> corners;
  for (size_t v = 0; v < used.size(); ++v) {
    if (used[v]) corners.push_back(mesh.positions[v]);
  }
  return corners;
}

}  // namespace

Image Render(const MeshArrays& mesh, const PictureContent& content,
             const PictureOptions& options) {
  const std::vector<Point> corners = Corners(mesh);
  const UpAxis up = options.up.value_or(GuessUpAxis(corners));
  const View view =
      options.direction.has_value()
          ? View{up, options.direction->azimuth, options.direction->elevation}
          : ChooseView(mesh, corners, Marks(content), up);
  const double margin = 0.05 * std::min(options.width, options.height);
  const double key =
      content.distances.empty() ? 0 : KeyWidth(options.width, options.height);
  const Rectangle area = {margin, margin,
                          options.width - margin - std::max(key, margin),
                          options.height - 2 * margin};
  const Camera camera(corners, view, area);
  const std::vector<Vector3> screen = OnScreen(mesh.positions, camera);
  const double largest = LargestFinite(content.distances);
  const double pen = std::max(0.8, options.height / 1100.0);
  const IsolineScale isolines =
      content.isolines ? ChooseIsolines(largest) : IsolineScale{};
  const Surface surface(mesh,
                        {content.distances, content.nearest_sources, largest},
                        screen, camera, isolines, pen);

  const VisibilityBuffer samples =
      Rasterize(screen, mesh.triangles, kSamples * options.width,
                kSamples * options.height);
  Image image(options.width, options.height);
  surface.Draw(samples, &image);
  if (key > 0 && content.nearest_sources.empty()) {
    DrawColorBar(surface.colormap(), isolines, content.levels, largest, &image);
  } else if (key > 0) {
    DrawSourceColors(content.source_names, ColorOfSource, &image);
  }
  DrawVisibleLines(OnScreen(content.thin_lines, camera), 1.3 * pen, kThinLine,
                   samples, &image);
  const std::vector<ScreenLine> bold = OnScreen(content.bold_lines, camera);
  // What is hidden shows faintly, so that a path is seen whole.
  DrawFaintLines(bold, 3 * pen, kBoldLine, &image);
  DrawVisibleLines(bold, 6 * pen, kRim, samples, &image);
  DrawVisibleLines(bold, 4 * pen, kBoldLine, samples, &image);
  const auto mark = [&](const char* name, const LinearColor& color,
                        const std::vector<Point>& points) {
    return DrawMarks(name, color, OnScreen(points, camera), samples, &image);
  };
  const std::vector<MarkStyle> targets =
      mark("target", kTargetMark, content.targets);
  std::vector<MarkStyle> styles = mark("source", kSourceMark, content.sources);
  styles.insert(styles.end(), targets.begin(), targets.end());
  DrawMarkLegend(styles, &image);
  return image;
}

}  // namespace geodesic::client
