#include "client/picture/line_overlay.h"

#include <algorithm>
#include <cmath>

namespace geodesic::client {
namespace {

// Pieces whose visibility is decided at their middle, in samples.
constexpr double kPiece = 2;

// Room for the slope of the surface between the middle of a sample and the
// line, in samples: what is nearer than this to the surface lies on it.
constexpr double kTolerance = 5;

int Clipped(double value, int count) {
  return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(count)));
}

}  // namespace

void LineOverlay::AddStroke(double x0, double y0, double x1, double y1,
                            double pen) {
  const double reach = pen / 2 + 1;
  const double dx = x1 - x0;
  const double dy = y1 - y0;
  const double length2 = dx * dx + dy * dy;
  if (!std::isfinite(length2)) return;
  const int x_end =
      Clipped(std::ceil(std::max(x0, x1) + reach), coverage_.width);
  const int y_end =
      Clipped(std::ceil(std::max(y0, y1) + reach), coverage_.height);
  for (int y = Clipped(std::floor(std::min(y0, y1) - reach), coverage_.height);
       y < y_end; ++y) {
    for (int x = Clipped(std::floor(std::min(x0, x1) - reach), coverage_.width);
         x < x_end; ++x) {
      const double px = x + 0.5 - x0;
      const double py = y + 0.5 - y0;
      const double t =
          length2 > 0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0;
      const double off = std::hypot(px - t * dx, py - t * dy);
      const auto covered =
          static_cast<float>(std::clamp(pen / 2 - off + 0.5, 0.0, 1.0));
      float& pixel = coverage_.At(x, y);
      pixel = std::max(pixel, covered);
    }
  }
}

void LineOverlay::AddLine(const std::vector<Vector3>& points, Parts parts,
                          double pen, int samples_per_pixel,
                          const VisibilityBuffer& buffer) {
  for (size_t i = 1; i < points.size(); ++i) {
    const Vector3& from = points[i - 1];
    const Vector3 step = points[i] - from;
    const double length = std::hypot(step.x, step.y);
    // Also false where a coordinate is no number.
    if (!(length < 1e6)) continue;
    const int pieces = 1 + static_cast<int>(length / kPiece);
    for (int k = 0; k < pieces; ++k) {
      const Vector3 middle = from + ((k + 0.5) / pieces) * step;
      if (parts == Parts::kVisible && !IsVisible(middle, kTolerance, buffer)) {
        continue;
      }
      const Vector3 a = from + (static_cast<double>(k) / pieces) * step;
      const Vector3 b = from + ((k + 1.0) / pieces) * step;
      AddStroke(a.x / samples_per_pixel, a.y / samples_per_pixel,
                b.x / samples_per_pixel, b.y / samples_per_pixel, pen);
    }
  }
}

void LineOverlay::Paint(const LinearColor& color, float strength,
                        LinearImage* image) const {
  for (size_t i = 0; i < image->pixels.size(); ++i) {
    image->pixels[i] =
        Mix(image->pixels[i], color, strength * coverage_.pixels[i]);
  }
}

}  // namespace geodesic::client
