#include "client/picture/key.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/str_cat.h"

namespace geodesic::client {
namespace {

// Where the key is; lengths in pixels.
struct Layout {
  explicit Layout(const Image& image)
      : text(TextSize(image.width(), image.height())),
        left(std::floor(image.width() -
                        0.94 * KeyWidth(image.width(), image.height()))),
        top(std::floor(0.16 * image.height())),
        bottom(std::floor(0.88 * image.height())) {}

  double text;
  double left, top, bottom;
};

void DrawTitle(const std::string& title, const Layout& at, Image* image) {
  image->SetInk(kTextInk);
  image->DrawText(title, at.left, at.top - at.text, 0.9 * at.text);
}

void DrawLine(double left, double right, double y, Image* image) {
  cairo_move_to(image->cairo(), left, y);
  cairo_line_to(image->cairo(), right, y);
  cairo_stroke(image->cairo());
}

}  // namespace

double TextSize(int picture_width, int picture_height) {
  return std::clamp(std::min(picture_width / 64.0, picture_height / 48.0), 9.0,
                    54.0);
}

double KeyWidth(int picture_width, int picture_height) {
  const double width = 10.5 * TextSize(picture_width, picture_height);
  return width < 0.4 * picture_width ? width : 0;
}

void DrawColorBar(const Colormap& colormap, const IsolineScale& isolines,
                  const std::vector<double>& levels, double largest,
                  Image* image) {
  const Layout at(*image);
  const double right = std::floor(at.left + 1.1 * at.text);
  const double pen = std::max(1.0, at.text / 12);
  // The bar is a surface seen face on, with the field rising up it.
  const double per_pixel = largest / (at.bottom - at.top);
  for (int y = static_cast<int>(at.top); y < at.bottom; ++y) {
    const double distance = (at.bottom - y - 0.5) * per_pixel;
    const auto line = static_cast<float>(
        0.8 * IsolineCoverage(isolines, distance, per_pixel, pen / 2));
    const LinearColor color =
        Mix(colormap.At((at.bottom - y - 0.5) / (at.bottom - at.top)), kTextInk,
            line);
    for (int x = static_cast<int>(at.left); x < right; ++x) {
      image->Set(x, y, color);
    }
  }
  image->SetInk(kTextInk);
  cairo_set_line_width(image->cairo(), pen);
  cairo_set_line_cap(image->cairo(), CAIRO_LINE_CAP_BUTT);
  for (const double level : levels) {
    DrawLine(at.left, right, at.bottom - level / per_pixel, image);
  }
  const IsolineScale scale =
      isolines.step == 0 ? ChooseIsolines(largest) : isolines;
  for (const ScaleLabel& label : ScaleLabels(scale, largest)) {
    const double y = at.bottom - label.distance / per_pixel;
    DrawLine(right, right + 0.3 * at.text, y, image);
    image->DrawText(label.text, right + 0.6 * at.text, y + 0.36 * at.text,
                    at.text);
  }
  DrawTitle("geodesic distance", at, image);
}

void DrawSourceColors(
    const std::vector<std::string>& names,
    const std::function<LinearColor(uint32_t source)>& color_of, Image* image) {
  const Layout at(*image);
  const double row = 1.6 * at.text;
  const auto rows = static_cast<size_t>((at.bottom - at.top) / row);
  // The last row says what there is no room for.
  const size_t shown = names.size() <= rows ? names.size() : rows - 1;
  double y = at.top;
  for (uint32_t source = 0; source < shown; ++source, y += row) {
    image->SetInk(color_of(source));
    cairo_rectangle(image->cairo(), at.left, y, 1.1 * at.text, 1.1 * at.text);
    cairo_fill(image->cairo());
    image->SetInk(kTextInk);
    image->DrawText(names[source], at.left + 1.7 * at.text, y + 0.9 * at.text,
                    at.text);
  }
  if (shown < names.size()) {
    image->DrawText(absl::StrCat("and ", names.size() - shown, " more"),
                    at.left, y + 0.9 * at.text, at.text);
  }
  DrawTitle("nearest source", at, image);
}

}  // namespace geodesic::client
