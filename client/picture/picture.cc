#include "client/picture/picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "client/picture/colormap.h"
#include "client/picture/corner_normals.h"
#include "client/picture/isolines.h"
#include "client/picture/nearest_cells.h"
#include "client/picture/overlay.h"
#include "client/picture/rasterizer.h"
#include "client/picture/vector3.h"

namespace geodesic::client {
namespace {

constexpr LinearColor kBackground = {1, 1, 1};
constexpr LinearColor kUnreachable = {0.55F, 0.55F, 0.55F};
constexpr LinearColor kPlain = {0.62F, 0.6F, 0.56F};
constexpr LinearColor kThinLine = {0.012F, 0.012F, 0.02F};
constexpr LinearColor kBoldLine = {0.75F, 0.02F, 0.02F};
constexpr LinearColor kRim = {1, 1, 1};
constexpr LinearColor kSourceMark = {0.75F, 0.02F, 0.02F};
constexpr LinearColor kTargetMark = {0.02F, 0.12F, 0.6F};

// A colour for each source, unlike those of the sources before and after it.
LinearColor ColorOfSource(uint32_t source) {
  // Hues a golden angle apart, with the lightness in three steps.
  constexpr double kGoldenAngle = 2.399963229728653;
  const double hue = source * kGoldenAngle;
  return Clamp(LinearFromOkLab({0.66 + 0.09 * (source % 3),
                                0.11 * std::cos(hue), 0.11 * std::sin(hue)}));
}

// Colours the mesh at each sample of the screen.
class Surface {
 public:
  // `largest` is the largest finite distance, `screen` holds the mesh's
  // vertices in samples, and `line_width` is the width of isolines in pixels.
  // Referenced arguments must outlive the object.
  Surface(const MeshArrays& mesh, const PictureContent& content, double largest,
          const std::vector<Vector3>& screen, const Camera& camera,
          const IsolineScale& isolines, double line_width)
      : mesh_(mesh),
        content_(content),
        largest_(largest),
        screen_(screen),
        camera_(camera),
        toward_lamp_(Normalized(-0.50 * camera.right() + 0.60 * camera.up() +
                                0.80 * camera.toward_viewer())),
        normals_(CornerNormals(mesh)),
        isolines_(isolines),
        line_width_(line_width) {
    if (!content.nearest_sources.empty()) {
      cells_.emplace(mesh, content.distances, content.nearest_sources);
    }
  }

  const Colormap& colormap() const { return colormap_; }

  // Sets the image's pixels to the average of their samples.
  void Draw(const VisibilityBuffer& samples, Image* image) const {
    constexpr float kWeight = 1.0F / (kSamples * kSamples);
    for (int y = 0; y < image->height(); ++y) {
      for (int x = 0; x < image->width(); ++x) {
        LinearColor sum = {0, 0, 0};
        for (int i = 0; i < kSamples * kSamples; ++i) {
          const int sample_x = kSamples * x + i % kSamples;
          const int sample_y = kSamples * y + i / kSamples;
          const uint32_t triangle = samples.At(sample_x, sample_y).triangle;
          sum = sum + (triangle == kNoTriangle
                           ? kBackground
                           : ColorAt(triangle, sample_x + 0.5, sample_y + 0.5));
        }
        image->Set(x, y, kWeight * sum);
      }
    }
  }

 private:
  // The colour of `triangle` at a point of the screen inside it.
  LinearColor ColorAt(uint32_t triangle, double x, double y) const {
    const Triangle& v = mesh_.triangles[triangle];
    const Barycentric weights =
        BarycentricAt(screen_[v[0]], screen_[v[1]], screen_[v[2]], x, y);
    const Vector3 normal = NormalAt(triangle, weights);
    const std::span<const double> distances = content_.distances;
    if (distances.empty()) return Shade(kPlain, normal);
    std::array<double, 3> d = {distances[v[0]], distances[v[1]],
                               distances[v[2]]};
    if (!std::isfinite(d[0]) || !std::isfinite(d[1]) || !std::isfinite(d[2])) {
      return Shade(kUnreachable, normal);
    }
    LinearColor albedo;
    if (cells_.has_value()) {
      const NearestCells::Nearest nearest = cells_->At(v, weights);
      albedo = ColorOfSource(nearest.source);
      d = nearest.corner_distances;
    }
    const double distance =
        weights[0] * d[0] + weights[1] * d[1] + weights[2] * d[2];
    if (!cells_.has_value()) {
      albedo = colormap_.At(largest_ > 0 ? distance / largest_ : 0);
    }
    const LinearColor color = Shade(albedo, normal);
    if (isolines_.step == 0) return color;
    const double line =
        IsolineCoverage(isolines_, distance, Gradient(v, d), line_width_);
    return Mix(color, kThinLine, static_cast<float>(0.85 * line));
  }

  // `albedo` under a lamp in front at the upper left, and soft light from above
  // and below that leaves no part black. Both sides of a face look alike.
  LinearColor Shade(const LinearColor& albedo, Vector3 normal) const {
    if (Dot(normal, camera_.toward_viewer()) < 0) normal = -1 * normal;
    const double lamp = std::max(0.0, Dot(normal, toward_lamp_));
    const double sky = 0.5 + 0.5 * Dot(normal, camera_.up());
    // A surface that faces the lamp keeps its colour, for comparison with the
    // colour bar.
    return static_cast<float>(0.27 + 0.16 * sky + 0.66 * lamp) * albedo;
  }

  Vector3 NormalAt(uint32_t triangle, const Barycentric& weights) const {
    const std::array<Normal, 3>& corners = normals_[triangle];
    Vector3 sum;
    for (int i = 0; i < 3; ++i) {
      sum = sum +
            weights[i] * Vector3{corners[i][0], corners[i][1], corners[i][2]};
    }
    return Normalized(sum);
  }

  // Change of the distance per pixel, in the direction of steepest change.
  double Gradient(const Triangle& triangle,
                  const std::array<double, 3>& distances) const {
    const Vector3& a = screen_[triangle[0]];
    const Vector3 b = screen_[triangle[1]] - a;
    const Vector3 c = screen_[triangle[2]] - a;
    const double to_b = distances[1] - distances[0];
    const double to_c = distances[2] - distances[0];
    return kSamples *
           std::hypot(to_b * c.y - to_c * b.y, to_c * b.x - to_b * c.x) /
           std::abs(b.x * c.y - b.y * c.x);
  }

  const MeshArrays& mesh_;
  const PictureContent& content_;
  const double largest_;
  const std::vector<Vector3>& screen_;
  const Camera& camera_;
  Vector3 toward_lamp_;
  std::vector<std::array<Normal, 3>> normals_;
  std::optional<NearestCells> cells_;
  Colormap colormap_;
  IsolineScale isolines_;
  double line_width_;
};

// The points on the screen, in samples.
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

// Points that a view should show: dots, and points along lines.
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

// The vertices of triangles. Stray vertices do not decide what is shown.
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

double LargestFinite(std::span<const double> distances) {
  double largest = 0;
  for (const double distance : distances) {
    if (std::isfinite(distance)) largest = std::max(largest, distance);
  }
  return largest;
}

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
  const Surface surface(mesh, content, largest, screen, camera, isolines, pen);

  const VisibilityBuffer samples =
      Rasterize(screen, mesh.triangles, kSamples * options.width,
                kSamples * options.height);
  Image image(options.width, options.height);
  surface.Draw(samples, &image);
  if (key > 0 && content.nearest_sources.empty()) {
    DrawColorBar(content.approximation.empty() ? "geodesic distance"
                 : content.approximation.starts_with("within")
                     ? "within tolerance"
                     : "approximate",
                 surface.colormap(), isolines, content.levels, largest, &image);
  } else if (key > 0) {
    DrawSourceColors(content.source_names, ColorOfSource, &image);
  }
  DrawVisibleLines(OnScreen(content.thin_lines, camera), 1.3 * pen, kThinLine,
                   samples, &image);
  const std::vector<ScreenLine> bold = OnScreen(content.bold_lines, camera);
  // Hidden parts show faintly, so a path can be seen whole.
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
  if (!content.approximation.empty()) {
    DrawPictureTitle(content.approximation, &image);
  }
  return image;
}

}  // namespace geodesic::client
