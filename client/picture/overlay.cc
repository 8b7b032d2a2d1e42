#include "client/picture/overlay.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "client/picture/key.h"

namespace geodesic::client {
namespace {

constexpr LinearColor kRim = {1, 1, 1};

// Pieces whose visibility is decided at their middle, in samples.
constexpr double kPiece = 2;

// Room for the slope of the surface between the middle of a sample and the
// line, in samples: what is nearer than this to the surface lies on it.
constexpr double kTolerance = 5;

// Whether a piece of a line is worth a look. Also false where a coordinate is
// no number, and for what would be too long for Cairo.
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
  // Six dashes and six gaps; round ends take a pen's width off the gaps.
  const double pen = 0.18 * size;
  const double sixth = size * std::numbers::pi / 6;
  const double dashes[] = {0.5 * sixth - pen / 2, 0.5 * sixth + pen / 2};
  cairo_set_line_width(cairo, pen);
  cairo_set_dash(cairo, dashes, 2, 0);
  cairo_stroke(cairo);
  cairo_set_dash(cairo, nullptr, 0, 0);
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
      // Begins the line where there is none yet.
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

}  // namespace geodesic::client
