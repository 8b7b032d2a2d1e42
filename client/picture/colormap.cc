#include "client/picture/colormap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace geodesic::client {
namespace {

// A point of the path in polar form.
struct Waypoint {
  double lightness;
  double chroma;
  double hue_degrees;
};

// Chosen by eye. They stay off black, on which shading could not show the
// shape.
constexpr std::array<Waypoint, 5> kWaypoints = {{{0.36, 0.150, 298},
                                                 {0.50, 0.125, 258},
                                                 {0.65, 0.105, 200},
                                                 {0.80, 0.165, 146},
                                                 {0.94, 0.175, 106}}};

// Catmull-Rom through p1 and p2.
double Spline(double p0, double p1, double p2, double p3, double t) {
  return p1 + 0.5 * t *
                  (p2 - p0 +
                   t * (2 * p0 - 5 * p1 + 4 * p2 - p3 +
                        t * (3 * (p1 - p2) + p3 - p0)));
}

OkLab PathAt(double t) {
  constexpr int kLast = static_cast<int>(kWaypoints.size()) - 1;
  const int segment = std::min(static_cast<int>(t * kLast), kLast - 1);
  const double s = t * kLast - segment;
  const Waypoint& p0 = kWaypoints[std::max(segment - 1, 0)];
  const Waypoint& p1 = kWaypoints[segment];
  const Waypoint& p2 = kWaypoints[segment + 1];
  const Waypoint& p3 = kWaypoints[std::min(segment + 2, kLast)];
  // Splines keep the path free of kinks.
  const double chroma = Spline(p0.chroma, p1.chroma, p2.chroma, p3.chroma, s);
  const double hue = Spline(p0.hue_degrees, p1.hue_degrees, p2.hue_degrees,
                            p3.hue_degrees, s) *
                     std::numbers::pi / 180;
  return {Spline(p0.lightness, p1.lightness, p2.lightness, p3.lightness, s),
          chroma * std::cos(hue), chroma * std::sin(hue)};
}

double Distance(const OkLab& a, const OkLab& b) {
  return std::hypot(a.lightness - b.lightness, a.a - b.a, a.b - b.b);
}

}  // namespace

LinearColor LinearFromOkLab(const OkLab& color) {
  const double l = std::pow(
      color.lightness + 0.3963377774 * color.a + 0.2158037573 * color.b, 3);
  const double m = std::pow(
      color.lightness - 0.1055613458 * color.a - 0.0638541728 * color.b, 3);
  const double s = std::pow(
      color.lightness - 0.0894841775 * color.a - 1.2914855480 * color.b, 3);
  return {static_cast<float>(4.0767416621 * l - 3.3077115913 * m +
                             0.2309699292 * s),
          static_cast<float>(-1.2684380046 * l + 2.6097574011 * m -
                             0.3413193965 * s),
          static_cast<float>(-0.0041960863 * l - 0.7034186147 * m +
                             1.7076147010 * s)};
}

Colormap::Colormap() {
  constexpr int kSteps = 4096;
  std::vector<double> walked(kSteps + 1, 0);
  for (int i = 1; i <= kSteps; ++i) {
    walked[i] =
        walked[i - 1] + Distance(PathAt((i - 1.0) / kSteps),
                                 PathAt(static_cast<double>(i) / kSteps));
  }
  int step = 0;
  for (int entry = 0; entry < kEntries; ++entry) {
    const double wanted = walked[kSteps] * entry / (kEntries - 1);
    while (step < kSteps && walked[step] < wanted) ++step;
    entries_[entry] =
        Clamp(LinearFromOkLab(PathAt(static_cast<double>(step) / kSteps)));
  }
}

LinearColor Colormap::At(double t) const {
  const double position = std::clamp(t, 0.0, 1.0) * (kEntries - 1);
  const int entry = std::min(static_cast<int>(position), kEntries - 2);
  return Mix(entries_[entry], entries_[entry + 1],
             static_cast<float>(position - entry));
}

}  // namespace geodesic::client
