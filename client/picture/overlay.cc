#include "client/picture/overlay.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "absl/strings/str_cat.h"

namespace geodesic::client {
namespace {

constexpr LinearColor kTextInk = {0.03F, 0.03F, 0.035F};
constexpr LinearColor kRim = {1, 1, 1};

// Length of a piece of a line in samples. The middle decides whether it is
// visible.
constexpr double kPiece = 2;

// A line lies on the surface if it is no more than this many samples behind it.
// This allows for the slope between the line and the middle of a sample.
constexpr double kTolerance = 5;

// Whether a piece of a line can be drawn. False also if a coordinate is NaN or
// the piece would be too long for Cairo.
bool IsDrawable(const Vector3& from, const Vector3& to) {
  constexpr double kFar = 1e6;
  return std::max({std::abs(from.x), std::abs(from.y), std::abs(to.x),
                   std::abs(to.y)}) < kFar &&
         std::isfinite(from.z) && std::isfinite(to.z);
}

// Adds the visible parts of a line to Cairo's path.
void AddVisible(const ScreenLine& line, const VisibilityBuffer& buffer,
                cairo_t* cairo) {
  bool is_down = false;
  for (size_t i = 1; i < line.size(); ++i) {
    const Vector3& from = line[i - 1];
    const Vector3 step = line[i] - from;
    if (!IsDrawable(from, line[i])) {
      is_down = false;
      continue;
    }
    const int pieces =
        1 + static_cast<int>(std::hypot(step.x, step.y) / kPiece);
    for (int k = 0; k < pieces; ++k) {
      const Vector3 at = from + (static_cast<double>(k) / pieces) * step;
      const Vector3 middle = from + ((k + 0.5) / pieces) * step;
      const bool is_visible = IsVisible(middle, kTolerance, buffer);
      if (is_visible == is_down) continue;
      if (is_visible) {
        cairo_move_to(cairo, at.x / kSamples, at.y / kSamples);
      } else {
        cairo_line_to(cairo, at.x / kSamples, at.y / kSamples);
      }
      is_down = is_visible;
    }
    if (is_down) {
      cairo_line_to(cairo, line[i].x / kSamples, line[i].y / kSamples);
    }
  }
}

double MarkSize(Image* image) {
  return 0.48 * TextSize(image->width(), image->height());
}

void DrawMark(const MarkStyle& style, double x, double y, Image* image) {
  cairo_t* cairo = image->cairo();
  const double size = MarkSize(image);
  cairo_new_path(cairo);
  cairo_arc(cairo, x, y, size / 2, 0, 2 * std::numbers::pi);
  image->SetInk(kRim);
  cairo_set_line_width(cairo, 0.4 * size);
  cairo_stroke_preserve(cairo);
  image->SetInk(style.color);
  if (!style.is_hidden) {
    cairo_fill(cairo);
    return;
  }
  // Six dashes and six gaps. Round ends shorten a gap by the pen's width.
  const double pen = 0.18 * size;
  const double sixth = size * std::numbers::pi / 6;
  const double dashes[] = {0.5 * sixth - pen / 2, 0.5 * sixth + pen / 2};
  cairo_set_line_width(cairo, pen);
  cairo_set_dash(cairo, dashes, 2, 0);
  cairo_stroke(cairo);
  cairo_set_dash(cairo, nullptr, 0, 0);
}

// Where the key is, in pixels.
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

void DrawVisibleLines(const std::vector<ScreenLine>& lines, double pen,
                      const LinearColor& color, const VisibilityBuffer& buffer,
                      Image* image) {
  image->SetInk(color);
  cairo_set_line_width(image->cairo(), pen);
  for (const ScreenLine& line : lines) {
    AddVisible(line, buffer, image->cairo());
    cairo_stroke(image->cairo());
  }
}

void DrawFaintLines(const std::vector<ScreenLine>& lines, double pen,
                    const LinearColor& color, Image* image) {
  constexpr double kStrength = 0.3;
  cairo_t* cairo = image->cairo();
  cairo_push_group(cairo);
  image->SetInk(color);
  cairo_set_line_width(cairo, pen);
  for (const ScreenLine& line : lines) {
    for (size_t i = 1; i < line.size(); ++i) {
      if (!IsDrawable(line[i - 1], line[i])) {
        cairo_new_sub_path(cairo);
        continue;
      }
      // This begins the line if there is no current point.
      cairo_line_to(cairo, line[i - 1].x / kSamples, line[i - 1].y / kSamples);
      cairo_line_to(cairo, line[i].x / kSamples, line[i].y / kSamples);
    }
    cairo_stroke(cairo);
  }
  cairo_pop_group_to_source(cairo);
  cairo_paint_with_alpha(cairo, kStrength);
}

std::vector<MarkStyle> DrawMarks(const std::string& name,
                                 const LinearColor& color,
                                 const std::vector<Vector3>& points,
                                 const VisibilityBuffer& buffer, Image* image) {
  const MarkStyle seen = {name, color, false};
  const MarkStyle hidden = {name + " (hidden)", color, true};
  // The surface around it may slope.
  const double tolerance = kSamples * MarkSize(image) / 2;
  std::vector<Vector3> visible;
  bool any_hidden = false;
  for (const Vector3& point : points) {
    if (!IsOnScreen(point, buffer)) continue;
    if (IsVisible(point, tolerance, buffer)) {
      visible.push_back(point);
    } else {
      DrawMark(hidden, point.x / kSamples, point.y / kSamples, image);
      any_hidden = true;
    }
  }
  for (const Vector3& point : visible) {
    DrawMark(seen, point.x / kSamples, point.y / kSamples, image);
  }
  std::vector<MarkStyle> styles;
  if (!visible.empty()) styles.push_back(seen);
  if (any_hidden) styles.push_back(hidden);
  return styles;
}

void DrawMarkLegend(const std::vector<MarkStyle>& styles, Image* image) {
  const double size = TextSize(image->width(), image->height());
  const double baseline = image->height() - 0.8 * size;
  double x = 2 * size;
  for (const MarkStyle& style : styles) {
    // Digits and small letters are centred on the mark.
    DrawMark(style, x, baseline - 0.3 * size, image);
    image->SetInk(kTextInk);
    x = image->DrawText(style.name, x + size, baseline, size) + 2.5 * size;
  }
}

void DrawPictureTitle(const std::string& title, Image* image) {
  const double size = TextSize(image->width(), image->height());
  image->SetInk(kTextInk);
  image->DrawText(image->Shortened(title, image->width() - 4 * size, size),
                  2 * size, 1.8 * size, size);
}

double TextSize(int picture_width, int picture_height) {
  return std::clamp(std::min(picture_width / 64.0, picture_height / 48.0), 9.0,
                    54.0);
}

double KeyWidth(int picture_width, int picture_height) {
  const double width = 10.5 * TextSize(picture_width, picture_height);
  return width < 0.4 * picture_width ? width : 0;
}

void DrawColorBar(const std::string& title, const Colormap& colormap,
                  const IsolineScale& isolines,
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
  DrawTitle(title, at, image);
}

void DrawSourceColors(
    const std::vector<std::string>& names,
    const std::function<LinearColor(uint32_t source)>& color_of, Image* image) {
  const Layout at(*image);
  const double row = 1.6 * at.text;
  const auto rows = static_cast<size_t>((at.bottom - at.top) / row);
  // The last row says how many sources there is no room for.
  const size_t shown = names.size() <= rows ? names.size() : rows - 1;
  double y = at.top;
  for (uint32_t source = 0; source < shown; ++source, y += row) {
    image->SetInk(color_of(source));
    cairo_rectangle(image->cairo(), at.left, y, 1.1 * at.text, 1.1 * at.text);
    cairo_fill(image->cairo());
    image->SetInk(kTextInk);
    const double left = at.left + 1.7 * at.text;
    const double width = image->width() - left - 0.5 * at.text;
    image->DrawText(image->Shortened(names[source], width, at.text), left,
                    y + 0.9 * at.text, at.text);
  }
  if (shown < names.size()) {
    image->DrawText(absl::StrCat("and ", names.size() - shown, " more"),
                    at.left, y + 0.9 * at.text, at.text);
  }
  DrawTitle("nearest source", at, image);
}

}  // namespace geodesic::client
