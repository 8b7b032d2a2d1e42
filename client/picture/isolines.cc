#include "client/picture/isolines.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace geodesic::client {
namespace {

double SmoothStep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// Coverage by the lines at multiples of `step`, `width` pixels wide.
double LinesCoverage(double step, double distance, double gradient,
                     double width) {
  const double nearest = step * std::round(distance / step);
  if (nearest <= 0) return 0;
  const double spacing = step / gradient;
  const double off = std::abs(distance - nearest) / gradient;
  // The ramp is half a pixel wide, as samples are half a pixel apart.
  const double inside = std::clamp((width / 2 - off) / 0.5 + 0.5, 0.0, 1.0);
  return inside * SmoothStep(2 * width, 4 * width, spacing);
}

}  // namespace

IsolineScale ChooseIsolines(double largest) {
  if (!(largest > 0) || !std::isfinite(largest)) return {};
  double power = std::pow(10, std::floor(std::log10(largest)));
  // 1 <= largest / power < 10, but for rounding and subnormal numbers.
  if (!(power > 0)) return {};
  const double leading = largest / power;
  if (leading < 2) return {power / 20, 4};    // Labels 0.2 apart.
  if (leading < 4.5) return {power / 10, 5};  // 0.5.
  return {power / 5, 5};                      // 1.
}

double IsolineCoverage(const IsolineScale& scale, double distance,
                       double gradient, double width) {
  if (!(scale.step > 0) || !(gradient > 0)) return 0;
  return std::max(
      0.75 * LinesCoverage(scale.step, distance, gradient, width),
      LinesCoverage(scale.label_step(), distance, gradient, 2 * width));
}

std::vector<ScaleLabel> ScaleLabels(const IsolineScale& scale, double largest) {
  std::vector<ScaleLabel> labels;
  if (!(scale.step > 0)) return labels;
  const double step = scale.label_step();
  for (int i = 0; i * step <= largest * (1 + 1e-12); ++i) {
    char text[32];
    // Labels are multiples of a round step. Six digits are enough for them, and
    // hide that 3 * 0.1 is not 0.3.
    std::snprintf(text, sizeof(text), "%.6g", i * step);
    labels.push_back({i * step, text});
  }
  return labels;
}

}  // namespace geodesic::client
