#include "client/picture/color_bar.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "client/picture/stroke_font.h"

namespace geodesic::client {
namespace {

constexpr std::string_view kTitle = "geodesic distance";
constexpr LinearColor kInk = {0.03F, 0.03F, 0.035F};

// Where everything goes; lengths in pixels.
struct Layout {
  Layout(int width, int height) {
    text = std::clamp(height / 64.0, 7.0, 40.0);
    pen = std::max(1.0, text / 9);
    const double room = ColorBarWidth(width, height);
    left = std::floor(width - room + 0.12 * room);
    right = std::floor(left + 1.5 * text);
    top = std::floor(0.16 * height);
    bottom = std::floor(0.88 * height);
  }

  double YAt(double fraction) const {
    return bottom - fraction * (bottom - top);
  }

  double text, pen, left, right, top, bottom;
};

}  // namespace

double ColorBarWidth(int picture_width, int picture_height) {
  const double text = std::clamp(picture_height / 64.0, 7.0, 40.0);
  return std::min(13 * text, 0.4 * picture_width);
}

void DrawColorBar(const Colormap& colormap, const IsolineScale& isolines,
                  const std::vector<double>& levels, double largest,
                  LinearImage* image) {
  const Layout at(image->width, image->height);
  for (int y = static_cast<int>(at.top); y < at.bottom; ++y) {
    const double fraction = (at.bottom - y - 0.5) / (at.bottom - at.top);
    // The bar is a surface seen face on, with the field rising up it.
    const double gradient = largest / (at.bottom - at.top);
    double covered = isolines.step == 0
                         ? 0
                         : IsolineCoverage(isolines, fraction * largest,
                                           gradient, at.pen / 2);
    for (const double level : levels) {
      const double off = std::abs(fraction * largest - level) / gradient;
      covered = std::max(covered, std::clamp(at.pen / 2 - off + 0.5, 0.0, 1.0));
    }
    const auto line = static_cast<float>(covered);
    const LinearColor color = Mix(colormap.At(fraction), kInk, 0.8F * line);
    for (int x = std::max(0, static_cast<int>(at.left));
         x < std::min<double>(at.right, image->width); ++x) {
      image->At(x, y) = color;
    }
  }
  const TextStyle style = {at.text, at.pen, kInk};
  const IsolineScale scale =
      isolines.step == 0 ? ChooseIsolines(largest) : isolines;
  for (const ScaleLabel& label : ScaleLabels(scale, largest)) {
    const double y = at.YAt(label.distance / largest);
    DrawStroke(at.right, y, at.right + 0.4 * at.text, y, at.pen, kInk, image);
    DrawText(label.text, at.right + 0.95 * at.text, y + at.text / 2, style,
             image);
  }
  const TextStyle title = {0.9 * at.text, at.pen, kInk};
  const double overhang = TextWidth(kTitle, title);
  const double left = std::min(at.left, image->width - overhang - at.text);
  DrawText(kTitle, left, at.top - 1.4 * at.text, title, image);
}

}  // namespace geodesic::client
