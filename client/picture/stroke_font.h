// Letters drawn with a pen of constant width, smooth at any size.

#ifndef GEODESIC_CLIENT_PICTURE_STROKE_FONT_H_
#define GEODESIC_CLIENT_PICTURE_STROKE_FONT_H_

#include <string_view>

#include "client/picture/image.h"

namespace geodesic::client {

// How text is set; lengths in pixels.
struct TextStyle {
  // Height of a digit.
  double height = 16;
  // Width of the pen.
  double pen = 1.6;
  LinearColor color;
};

// Width of a line of text.
double TextWidth(std::string_view text, const TextStyle& style);

// Writes a line whose left end is at `left` and whose digits stand on
// `baseline`. Knows digits, ".-+ " and the lower-case letters; what it does not
// know is left blank.
void DrawText(std::string_view text, double left, double baseline,
              const TextStyle& style, LinearImage* image);

// A straight stroke with round ends.
void DrawStroke(double x0, double y0, double x1, double y1, double pen,
                const LinearColor& color, LinearImage* image);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_STROKE_FONT_H_
