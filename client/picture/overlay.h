// What is drawn over the surface: lines and marks on it, and beside it the key,
// which tells what distance or which source each colour means.

#ifndef GEODESIC_CLIENT_PICTURE_OVERLAY_H_
#define GEODESIC_CLIENT_PICTURE_OVERLAY_H_

#include <functional>
#include <string>
#include <vector>

#include "client/picture/colormap.h"
#include "client/picture/image.h"
#include "client/picture/isolines.h"
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

// The size of letters in a picture of this size, in pixels.
double TextSize(int picture_width, int picture_height);

// Room the key takes at the right, in pixels. Nothing if the picture is too
// narrow for one.
double KeyWidth(int picture_width, int picture_height);

// The colours of 0 to `largest` in a bar, with `isolines` or, if it has none,
// lines at `levels`.
// REQUIRES: KeyWidth is not 0.
void DrawColorBar(const Colormap& colormap, const IsolineScale& isolines,
                  const std::vector<double>& levels, double largest,
                  Image* image);

// The colours of nearest sources, by the sources' names; as many, and as much
// of each, as there is room for. REQUIRES: KeyWidth is not 0.
void DrawSourceColors(
    const std::vector<std::string>& names,
    const std::function<LinearColor(uint32_t source)>& color_of, Image* image);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_OVERLAY_H_
