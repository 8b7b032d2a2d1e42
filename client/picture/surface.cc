#include "client/picture/surface.h"

#include <algorithm>
#include <cmath>

namespace geodesic::client {
namespace {

constexpr LinearColor kBackground = {1, 1, 1};
constexpr LinearColor kUnreachable = {0.55F, 0.55F, 0.55F};
constexpr LinearColor kPlain = {0.62F, 0.6F, 0.56F};
constexpr LinearColor kLineInk = {0.012F, 0.012F, 0.02F};

}  // namespace

LinearColor ColorOfSource(uint32_t source) {
  // Hues a golden angle apart, with the lightness in three steps.
  constexpr double kGoldenAngle = 2.399963229728653;
  const double hue = source * kGoldenAngle;
  return Clamp(LinearFromOkLab({0.66 + 0.09 * (source % 3),
                                0.11 * std::cos(hue), 0.11 * std::sin(hue)}));
}

Surface::Surface(const MeshArrays& mesh, const Values& values,
                 const std::vector<Vector3>& screen, const Camera& camera,
                 const IsolineScale& isolines, double line_width)
    : mesh_(mesh),
      values_(values),
      screen_(screen),
      camera_(camera),
      toward_lamp_(Normalized(-0.50 * camera.right() + 0.60 * camera.up() +
                              0.80 * camera.toward_viewer())),
      normals_(CornerNormals(mesh)),
      isolines_(isolines),
      line_width_(line_width) {
  if (!values.nearest_sources.empty()) {
    cells_.emplace(mesh, values.distances, values.nearest_sources);
  }
}

void Surface::Draw(const VisibilityBuffer& samples, Image* image) const {
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

LinearColor Surface::ColorAt(uint32_t triangle, double x, double y) const {
  const Triangle& v = mesh_.triangles[triangle];
  const Barycentric weights =
      BarycentricAt(screen_[v[0]], screen_[v[1]], screen_[v[2]], x, y);
  const Vector3 normal = NormalAt(triangle, weights);
  const std::span<const double> distances = values_.distances;
  if (distances.empty()) return Shade(kPlain, normal);
  std::array<double, 3> d = {distances[v[0]], distances[v[1]], distances[v[2]]};
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
      weights.a * d[0] + weights.b * d[1] + weights.c * d[2];
  if (!cells_.has_value()) {
    albedo = colormap_.At(values_.largest > 0 ? distance / values_.largest : 0);
  }
  const LinearColor color = Shade(albedo, normal);
  if (isolines_.step == 0) return color;
  const double line =
      IsolineCoverage(isolines_, distance, Gradient(v, d), line_width_);
  return Mix(color, kLineInk, static_cast<float>(0.85 * line));
}

LinearColor Surface::Shade(const LinearColor& albedo, Vector3 normal) const {
  if (Dot(normal, camera_.toward_viewer()) < 0) normal = -1 * normal;
  const double lamp = std::max(0.0, Dot(normal, toward_lamp_));
  const double sky = 0.5 + 0.5 * Dot(normal, camera_.up());
  // A surface that faces the lamp keeps its colour, so that it can be read off
  // the colour bar.
  return static_cast<float>(0.27 + 0.16 * sky + 0.66 * lamp) * albedo;
}

Vector3 Surface::NormalAt(uint32_t triangle, const Barycentric& weights) const {
  const std::array<Normal, 3>& corners = normals_[triangle];
  const std::array<double, 3> w = {weights.a, weights.b, weights.c};
  Vector3 sum;
  for (int i = 0; i < 3; ++i) {
    sum = sum + w[i] * Vector3{corners[i][0], corners[i][1], corners[i][2]};
  }
  return Normalized(sum);
}

double Surface::Gradient(const Triangle& triangle,
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

}  // namespace geodesic::client
