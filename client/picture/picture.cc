#include "client/picture/picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "client/picture/color_bar.h"
#include "client/picture/colormap.h"
#include "client/picture/corner_normals.h"
#include "client/picture/default_view.h"
#include "client/picture/isolines.h"
#include "client/picture/line_overlay.h"
#include "client/picture/rasterizer.h"
#include "client/picture/shading.h"
#include "client/picture/stroke_font.h"

namespace geodesic::client {
namespace {

// Samples a pixel has, across and down.
constexpr int kSamples = 2;

constexpr LinearColor kBackground = {1, 1, 1};
constexpr LinearColor kUnreachable = {0.55F, 0.55F, 0.55F};
constexpr LinearColor kPlain = {0.62F, 0.6F, 0.56F};
constexpr LinearColor kLineInk = {0.012F, 0.012F, 0.02F};
constexpr LinearColor kSourceFill = {0.75F, 0.02F, 0.02F};
constexpr LinearColor kTargetFill = {0.02F, 0.12F, 0.6F};
constexpr LinearColor kRim = {1, 1, 1};
constexpr LinearColor kBoldLine = {0.75F, 0.02F, 0.02F};

// A colour for each number, far from those of its neighbours: hues a golden
// angle apart, with the lightness in three steps.
LinearColor ColorOfLabel(uint32_t label) {
  constexpr double kGoldenAngle = 2.399963229728653;
  const double hue = label * kGoldenAngle;
  const double lightness = 0.66 + 0.09 * (label % 3);
  const LinearColor color =
      LinearFromOkLab({lightness, 0.11 * std::cos(hue), 0.11 * std::sin(hue)});
  return {std::clamp(color.red, 0.0F, 1.0F),
          std::clamp(color.green, 0.0F, 1.0F),
          std::clamp(color.blue, 0.0F, 1.0F)};
}

// A mesh on the screen, and all that colours a sample of it.
class Scene {
 public:
  Scene(const MeshArrays& mesh, const PictureContent& content,
        const Camera& camera, double largest, double line_width)
      : mesh_(mesh),
        distances_(content.distances),
        labels_(content.labels),
        camera_(camera),
        screen_(OnScreen(mesh.positions)),
        normals_(CornerNormals(mesh)),
        lighting_(camera),
        isolines_(content.isolines ? ChooseIsolines(largest) : IsolineScale{}),
        largest_(largest),
        line_width_(line_width) {}

  // In samples: lengths are divided by kSamples to be in pixels.
  Vector3 OnScreen(const Point& point) const {
    return kSamples * camera_.Project(point);
  }
  std::vector<Vector3> OnScreen(const std::vector<Point>& points) const {
    std::vector<Vector3> screen;
    screen.reserve(points.size());
    for (const Point& point : points) screen.push_back(OnScreen(point));
    return screen;
  }

  const std::vector<Vector3>& screen() const { return screen_; }
  const Colormap& colormap() const { return colormap_; }
  const IsolineScale& isolines() const { return isolines_; }
  double line_width() const { return line_width_; }

  // The colour of `triangle` at a point of the screen inside it.
  LinearColor ColorAt(uint32_t triangle, double x, double y) const {
    const Triangle& v = mesh_.triangles[triangle];
    const Vector3& a = screen_[v[0]];
    const Vector3& b = screen_[v[1]];
    const Vector3& c = screen_[v[2]];
    const Barycentric weights = BarycentricAt(a, b, c, x, y);
    const Vector3 normal = NormalAt(triangle, weights);
    if (distances_.empty()) return lighting_.Shade(kPlain, normal);
    const std::array<double, 3> d = {distances_[v[0]], distances_[v[1]],
                                     distances_[v[2]]};
    if (!std::isfinite(d[0]) || !std::isfinite(d[1]) || !std::isfinite(d[2])) {
      return lighting_.Shade(kUnreachable, normal);
    }
    const double distance =
        weights.a * d[0] + weights.b * d[1] + weights.c * d[2];
    const LinearColor albedo =
        labels_.empty() ? colormap_.At(largest_ > 0 ? distance / largest_ : 0)
                        : ColorOfLabel(labels_[HeaviestCorner(v, weights)]);
    const LinearColor color = lighting_.Shade(albedo, normal);
    if (isolines_.step == 0) return color;
    const double line =
        IsolineCoverage(isolines_, distance, Gradient(a, b, c, d), line_width_);
    return Mix(color, kLineInk, static_cast<float>(0.85 * line));
  }

 private:
  static uint32_t HeaviestCorner(const Triangle& v,
                                 const Barycentric& weights) {
    if (weights.a >= weights.b && weights.a >= weights.c) return v[0];
    return weights.b >= weights.c ? v[1] : v[2];
  }

  Vector3 NormalAt(uint32_t triangle, const Barycentric& weights) const {
    const std::array<Normal, 3>& corners = normals_[triangle];
    Vector3 sum;
    const std::array<double, 3> w = {weights.a, weights.b, weights.c};
    for (int i = 0; i < 3; ++i) {
      sum = sum + w[i] * Vector3{corners[i][0], corners[i][1], corners[i][2]};
    }
    return Normalized(sum);
  }

  // Change of the distance per pixel, in the direction it changes most.
  static double Gradient(const Vector3& a, const Vector3& b, const Vector3& c,
                         const std::array<double, 3>& d) {
    const double area2 = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const double by_x =
        ((d[1] - d[0]) * (c.y - a.y) - (d[2] - d[0]) * (b.y - a.y)) / area2;
    const double by_y =
        ((d[2] - d[0]) * (b.x - a.x) - (d[1] - d[0]) * (c.x - a.x)) / area2;
    return kSamples * std::hypot(by_x, by_y);
  }

  const MeshArrays& mesh_;
  std::span<const double> distances_;
  std::span<const uint32_t> labels_;
  const Camera& camera_;
  std::vector<Vector3> screen_;
  std::vector<std::array<Normal, 3>> normals_;
  Lighting lighting_;
  Colormap colormap_;
  IsolineScale isolines_;
  double largest_;
  double line_width_;
};

// Averages each pixel's samples, in linear light.
void DrawSamples(const Scene& scene, const VisibilityBuffer& samples,
                 LinearImage* image) {
  constexpr float kWeight = 1.0F / (kSamples * kSamples);
  for (int y = 0; y < samples.height; ++y) {
    for (int x = 0; x < samples.width; ++x) {
      const uint32_t triangle = samples.At(x, y).triangle;
      const LinearColor color = triangle == kNoTriangle
                                    ? kBackground
                                    : scene.ColorAt(triangle, x + 0.5, y + 0.5);
      LinearColor& pixel = image->At(x / kSamples, y / kSamples);
      pixel = pixel + kWeight * color;
    }
  }
}

void DrawDots(const Scene& scene, const VisibilityBuffer& samples,
              const std::vector<Point>& points, const LinearColor& fill,
              LinearImage* image) {
  const double size = std::clamp(image->height / 100.0, 4.0, 24.0);
  for (const Point& position : points) {
    const Vector3 point = scene.OnScreen(position);
    // The surface around it may slope.
    if (!IsVisible(point, kSamples * size / 2, samples)) continue;
    const double x = point.x / kSamples;
    const double y = point.y / kSamples;
    DrawStroke(x, y, x, y, 1.4 * size, kRim, image);
    DrawStroke(x, y, x, y, size, fill, image);
  }
}

// How lines are drawn.
struct LineStyle {
  LineOverlay::Parts parts = LineOverlay::Parts::kVisible;
  double pen = 1;
  LinearColor color;
  float strength = 1;
};

void DrawLines(const Scene& scene, const VisibilityBuffer& samples,
               const std::vector<PictureLine>& lines, const LineStyle& style,
               LinearImage* image) {
  if (lines.empty()) return;
  LineOverlay overlay(image->width, image->height);
  for (const PictureLine& line : lines) {
    std::vector<Vector3> points = scene.OnScreen(line.points);
    if (line.is_closed && !points.empty()) points.push_back(points[0]);
    overlay.AddLine(points, style.parts, style.pen, kSamples, samples);
  }
  overlay.Paint(style.color, style.strength, image);
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
  const bool has_bar = !content.distances.empty() && content.labels.empty();
  const double margin = 0.05 * std::min(options.width, options.height);
  const double right =
      has_bar ? ColorBarWidth(options.width, options.height) : margin;
  const Rectangle area = {margin, margin, options.width - right - margin,
                          options.height - 2 * margin};
  const Camera camera(corners, view, area);
  const double largest = LargestFinite(content.distances);
  const Scene scene(mesh, content, camera, largest,
                    std::max(0.8, options.height / 1100.0));

  const VisibilityBuffer samples =
      Rasterize(scene.screen(), mesh.triangles, kSamples * options.width,
                kSamples * options.height);
  LinearImage image(options.width, options.height, LinearColor{});
  DrawSamples(scene, samples, &image);
  const double pen = scene.line_width();
  const auto draw = [&](const std::vector<PictureLine>& lines,
                        const LineStyle& style) {
    DrawLines(scene, samples, lines, style, &image);
  };
  draw(content.thin_lines, {.pen = 1.3 * pen, .color = kLineInk});
  // What is hidden shows faintly, so that a path is seen whole.
  draw(content.bold_lines, {.parts = LineOverlay::Parts::kAll,
                            .pen = 3 * pen,
                            .color = kBoldLine,
                            .strength = 0.3F});
  draw(content.bold_lines, {.pen = 6 * pen, .color = kRim});
  draw(content.bold_lines, {.pen = 4 * pen, .color = kBoldLine});
  DrawDots(scene, samples, content.targets, kTargetFill, &image);
  DrawDots(scene, samples, content.sources, kSourceFill, &image);
  if (has_bar) {
    DrawColorBar(scene.colormap(), scene.isolines(), content.levels, largest,
                 &image);
  }
  return Encode(image);
}

}  // namespace geodesic::client
