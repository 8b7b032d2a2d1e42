#include "client/picture/picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "client/picture/color_bar.h"
#include "client/picture/colormap.h"
#include "client/picture/corner_normals.h"
#include "client/picture/default_view.h"
#include "client/picture/isolines.h"
#include "client/picture/rasterizer.h"
#include "client/picture/shading.h"
#include "client/picture/stroke_font.h"

namespace geodesic::client {
namespace {

// Samples a pixel has, across and down.
constexpr int kSamples = 2;

constexpr LinearColor kBackground = {1, 1, 1};
constexpr LinearColor kUnreachable = {0.55F, 0.55F, 0.55F};
constexpr LinearColor kLineInk = {0.012F, 0.012F, 0.02F};
constexpr LinearColor kSourceFill = {0.75F, 0.02F, 0.02F};
constexpr LinearColor kSourceRim = {1, 1, 1};

// A mesh on the screen, and all that colours a sample of it.
class Scene {
 public:
  Scene(const MeshArrays& mesh, const std::vector<double>& distances,
        const Camera& camera, double largest, double line_width)
      : mesh_(mesh),
        distances_(distances),
        normals_(CornerNormals(mesh)),
        lighting_(camera),
        isolines_(ChooseIsolines(largest)),
        largest_(largest),
        line_width_(line_width) {
    screen_.reserve(mesh.positions.size());
    for (const Point& point : mesh.positions) {
      // In samples: lengths below are divided by kSamples to be in pixels.
      screen_.push_back(kSamples * camera.Project(point));
    }
  }

  const std::vector<Vector3>& screen() const { return screen_; }
  const Colormap& colormap() const { return colormap_; }
  const IsolineScale& isolines() const { return isolines_; }

  // The colour of `triangle` at a point of the screen inside it.
  LinearColor ColorAt(uint32_t triangle, double x, double y) const {
    const Triangle& v = mesh_.triangles[triangle];
    const Vector3& a = screen_[v[0]];
    const Vector3& b = screen_[v[1]];
    const Vector3& c = screen_[v[2]];
    const Barycentric weights = BarycentricAt(a, b, c, x, y);
    const Vector3 normal = NormalAt(triangle, weights);
    const std::array<double, 3> d = {distances_[v[0]], distances_[v[1]],
                                     distances_[v[2]]};
    if (!std::isfinite(d[0]) || !std::isfinite(d[1]) || !std::isfinite(d[2])) {
      return lighting_.Shade(kUnreachable, normal);
    }
    const double distance =
        weights.a * d[0] + weights.b * d[1] + weights.c * d[2];
    LinearColor color = lighting_.Shade(
        colormap_.At(largest_ > 0 ? distance / largest_ : 0), normal);
    const double line =
        IsolineCoverage(isolines_, distance, Gradient(a, b, c, d), line_width_);
    return Mix(color, kLineInk, static_cast<float>(0.85 * line));
  }

 private:
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
  const std::vector<double>& distances_;
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

void DrawSources(const Scene& scene, const VisibilityBuffer& samples,
                 const std::vector<uint64_t>& sources, LinearImage* image) {
  const double size = std::clamp(image->height / 100.0, 4.0, 24.0);
  for (const uint64_t source : sources) {
    if (source >= scene.screen().size()) continue;
    const Vector3& point = scene.screen()[source];
    // The surface around it may slope.
    if (!IsVisible(point, kSamples * size / 2, samples)) continue;
    const double x = point.x / kSamples;
    const double y = point.y / kSamples;
    DrawStroke(x, y, x, y, 1.4 * size, kSourceRim, image);
    DrawStroke(x, y, x, y, size, kSourceFill, image);
  }
}

double LargestFinite(const std::vector<double>& distances) {
  double largest = 0;
  for (const double distance : distances) {
    if (std::isfinite(distance)) largest = std::max(largest, distance);
  }
  return largest;
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

Image RenderField(const MeshArrays& mesh, const std::vector<double>& distances,
                  const std::vector<uint64_t>& sources,
                  const PictureOptions& options) {
  const std::vector<Point> corners = Corners(mesh);
  const UpAxis up = options.up.value_or(GuessUpAxis(corners));
  const View view =
      options.direction.has_value()
          ? View{up, options.direction->azimuth, options.direction->elevation}
          : ChooseView(mesh, corners, sources, up);
  const double margin = 0.05 * std::min(options.width, options.height);
  const Rectangle area = {
      margin, margin,
      options.width - ColorBarWidth(options.width, options.height) - margin,
      options.height - 2 * margin};
  const Camera camera(corners, view, area);
  const double largest = LargestFinite(distances);
  const Scene scene(mesh, distances, camera, largest,
                    std::max(0.8, options.height / 1100.0));

  const VisibilityBuffer samples =
      Rasterize(scene.screen(), mesh.triangles, kSamples * options.width,
                kSamples * options.height);
  LinearImage image(options.width, options.height, LinearColor{});
  DrawSamples(scene, samples, &image);
  DrawSources(scene, samples, sources, &image);
  DrawColorBar(scene.colormap(), scene.isolines(), largest, &image);
  return Encode(image);
}

}  // namespace geodesic::client
