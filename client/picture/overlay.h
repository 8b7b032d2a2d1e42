// Lines and marks on the surface, drawn over the picture.

#ifndef GEODESIC_CLIENT_PICTURE_OVERLAY_H_
#define GEODESIC_CLIENT_PICTURE_OVERLAY_H_

#include <string>
#include <vector>

#include "client/picture/image.h"
#include "client/picture/rasterizer.h"
#include "client/picture/vector3.h"

namespace geodesic::client {

// A line's points in samples, of which a pixel has kSamples across.
using ScreenLine = std::vector<Vector3>;

// The parts of the lines that nothing hides, `pen` pixels wide.
void DrawVisibleLines(const std::vector<ScreenLine>& lines, double pen,
                      const LinearColor& color, const VisibilityBuffer& buffer,
                      Image* image);

// All of the lines, faintly. Where they overlap they are no darker.
void DrawFaintLines(const std::vector<ScreenLine>& lines, double pen,
                    const LinearColor& color, Image* image);

// How a mark is drawn, and what is written beside it in the legend.
struct MarkStyle {
  std::string name;
  LinearColor color;
  // A dashed ring, not a dot.
  bool is_hidden = false;
};

// Marks the points (in samples): with dots those that are seen, with dashed
// rings those that something hides. What is off the screen is left out. Returns
// the styles that occurred.
std::vector<MarkStyle> DrawMarks(const std::string& name,
                                 const LinearColor& color,
                                 const std::vector<Vector3>& points,
                                 const VisibilityBuffer& buffer, Image* image);

// Tells the marks' names below the picture.
void DrawMarkLegend(const std::vector<MarkStyle>& styles, Image* image);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_OVERLAY_H_
