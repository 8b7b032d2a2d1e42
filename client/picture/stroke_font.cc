#include "client/picture/stroke_font.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace geodesic::client {
namespace {

// Glyphs live in a box whose baseline is y = 0, digit height is 10 and
// lower-case height is 7; y points up.
struct PenPoint {
  double x;
  double y;
};
using Stroke = std::vector<PenPoint>;

// The arc of an ellipse from one angle to another, in degrees
// counter-clockwise from +x.
Stroke Arc(double cx, double cy, double rx, double ry, double from, double to) {
  constexpr int kSegments = 20;
  Stroke stroke;
  for (int i = 0; i <= kSegments; ++i) {
    const double angle =
        (from + (to - from) * i / kSegments) * std::numbers::pi / 180;
    stroke.push_back({cx + rx * std::cos(angle), cy + ry * std::sin(angle)});
  }
  return stroke;
}

Stroke Join(Stroke first, const Stroke& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

struct Glyph {
  double width = 0;
  std::vector<Stroke> strokes;
};

Glyph DigitGlyph(char c) {
  constexpr double kWidth = 6;
  switch (c) {
    case '0':
      return {kWidth, {Arc(3, 5, 3, 5, 0, 360)}};
    case '1':
      return {kWidth, {{{1, 8}, {3.4, 10}, {3.4, 0}}}};
    case '2':
      return {kWidth,
              {Join(Arc(3, 7.1, 2.8, 2.9, 165, -35), {{0, 0}, {6, 0}})}};
    case '3':
      return {kWidth,
              {Arc(2.9, 7.6, 2.5, 2.4, 150, -90),
               Arc(2.9, 2.7, 2.9, 2.7, 90, -150)}};
    case '4':
      return {kWidth, {{{4.6, 0}, {4.6, 10}, {0, 3}, {6.2, 3}}}};
    case '5':
      return {kWidth,
              {Join({{5.4, 10}, {1, 10}, {0.6, 5.4}},
                    Arc(2.9, 3.3, 3, 3.3, 130, -150))}};
    case '6':
      return {kWidth,
              {Arc(3, 3.2, 3, 3.2, 0, 360),
               Join({{4.9, 10}, {3.6, 9.2}}, Arc(5.6, 3.2, 5.6, 7, 130, 180))}};
    case '7':
      return {kWidth, {{{0, 10}, {6, 10}, {2, 0}}}};
    case '8':
      return {kWidth,
              {Arc(3, 7.6, 2.5, 2.4, 0, 360), Arc(3, 2.6, 3, 2.6, 0, 360)}};
    case '9':
      return {kWidth,
              {Arc(3, 6.8, 3, 3.2, 0, 360),
               Join({{1.1, 0}, {2.4, 0.8}}, Arc(0.4, 6.8, 5.6, 7, -50, 0))}};
    default:
      return {kWidth, {}};
  }
}

Glyph LetterGlyph(char c) {
  const Stroke bowl = Arc(2.7, 3.5, 2.7, 3.5, 0, 360);
  switch (c) {
    case 'a':
      return {5.4, {bowl, {{5.4, 7}, {5.4, 0}}}};
    case 'b':
      return {5.4, {bowl, {{0, 10.5}, {0, 0}}}};
    case 'c':
      return {4.6, {Arc(2.7, 3.5, 2.7, 3.5, 45, 315)}};
    case 'd':
      return {5.4, {bowl, {{5.4, 10.5}, {5.4, 0}}}};
    case 'e':
      return {
          5.4,
          {Join({{0.1, 3.7}, {5.3, 3.7}}, Arc(2.7, 3.5, 2.7, 3.5, 5, 320))}};
    case 'g':
      return {5.4,
              {bowl, Join({{5.4, 7}, {5.4, 0}}, Arc(2.7, 0, 2.7, 3, 0, -150))}};
    case 'h':
      return {5,
              {{{0, 10.5}, {0, 0}},
               Join(Arc(2.5, 4.4, 2.5, 2.6, 180, 0), {{5, 0}})}};
    case 'i':
      return {0.4, {{{0.2, 7}, {0.2, 0}}, {{0.2, 9.6}, {0.2, 9.7}}}};
    case 'l':
      return {0.4, {{{0.2, 10.5}, {0.2, 0}}}};
    case 'n':
      return {
          5,
          {{{0, 7}, {0, 0}}, Join(Arc(2.5, 4.4, 2.5, 2.6, 180, 0), {{5, 0}})}};
    case 'o':
      return {5.4, {bowl}};
    case 'r':
      return {2.8, {{{0, 7}, {0, 0}}, Arc(2.6, 4, 2.6, 3, 180, 85)}};
    case 's':
      return {4.4,
              {Join(Arc(2.2, 5.2, 2, 1.8, 45, 255),
                    Arc(2.2, 1.75, 2.2, 1.75, 75, -145))}};
    case 't':
      return {3.2,
              {Join({{1.2, 9.4}}, Arc(3.2, 1.8, 2, 1.8, 180, 280)),
               {{0, 7}, {3, 7}}}};
    case 'u':
      return {5,
              {Join({{0, 7}}, Arc(2.5, 2.6, 2.5, 2.6, 180, 360)),
               {{5, 7}, {5, 0}}}};
    default:
      return {5, {}};
  }
}

Glyph GlyphOf(char c) {
  switch (c) {
    case '.':
      return {0.6, {{{0.3, 0.1}, {0.3, 0}}}};
    case '-':
      return {4, {{{0.3, 4}, {3.7, 4}}}};
    case '+':
      return {5, {{{0.3, 4}, {4.7, 4}}, {{2.5, 6.2}, {2.5, 1.8}}}};
    case ' ':
      return {3, {}};
    default:
      return c >= '0' && c <= '9' ? DigitGlyph(c) : LetterGlyph(c);
  }
}

// Between two glyphs.
constexpr double kGap = 2.2;

// How far a point is from a stroke's straight piece.
double DistanceToPiece(double x, double y, const PenPoint& a,
                       const PenPoint& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  const double t =
      length2 > 0
          ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / length2, 0.0, 1.0)
          : 0;
  return std::hypot(x - a.x - t * dx, y - a.y - t * dy);
}

// Covers every pixel once, however many pieces of the stroke come near it.
void Draw(const Stroke& stroke, double pen, const LinearColor& color,
          LinearImage* image) {
  if (stroke.empty()) return;
  const auto [left, right] = std::ranges::minmax(stroke, {}, &PenPoint::x);
  const auto [top, bottom] = std::ranges::minmax(stroke, {}, &PenPoint::y);
  const double reach = pen / 2 + 1;
  const auto clip = [](double value, int count) {
    return static_cast<int>(std::clamp(value, 0.0, double(count)));
  };
  const int x_end = clip(std::ceil(right.x + reach), image->width);
  const int y_end = clip(std::ceil(bottom.y + reach), image->height);
  for (int y = clip(std::floor(top.y - reach), image->height); y < y_end; ++y) {
    for (int x = clip(std::floor(left.x - reach), image->width); x < x_end;
         ++x) {
      double off = DistanceToPiece(x + 0.5, y + 0.5, stroke[0], stroke[0]);
      for (size_t i = 1; i < stroke.size(); ++i) {
        off = std::min(
            off, DistanceToPiece(x + 0.5, y + 0.5, stroke[i - 1], stroke[i]));
      }
      const double coverage = std::clamp(pen / 2 - off + 0.5, 0.0, 1.0);
      LinearColor& pixel = image->At(x, y);
      pixel = Mix(pixel, color, static_cast<float>(coverage));
    }
  }
}

}  // namespace

double TextWidth(std::string_view text, const TextStyle& style) {
  double width = 0;
  for (const char c : text) width += GlyphOf(c).width + kGap;
  return text.empty() ? 0 : (width - kGap) * style.height / 10;
}

void DrawText(std::string_view text, double left, double baseline,
              const TextStyle& style, LinearImage* image) {
  const double scale = style.height / 10;
  for (const char c : text) {
    const Glyph glyph = GlyphOf(c);
    for (const Stroke& stroke : glyph.strokes) {
      Stroke placed;
      for (const PenPoint& point : stroke) {
        placed.push_back({left + scale * point.x, baseline - scale * point.y});
      }
      Draw(placed, style.pen, style.color, image);
    }
    left += (glyph.width + kGap) * scale;
  }
}

void DrawStroke(double x0, double y0, double x1, double y1, double pen,
                const LinearColor& color, LinearImage* image) {
  Draw({{x0, y0}, {x1, y1}}, pen, color, image);
}

}  // namespace geodesic::client
