// Draws lines and marks over the surface, and beside it the key, which tells
// what distance or which source each colour means.

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

// A line's points, in samples. A pixel is kSamples samples wide.
using ScreenLine = std::vector<Vector3>;

// Draws the visible parts of the lines, `pen` pixels wide.
void DrawVisibleLines(const std::vector<ScreenLine>& lines, double pen,
                      const LinearColor& color, const VisibilityBuffer& buffer,
                      Image* image);

// Draws all of the lines faintly. They are no darker where they overlap.
void DrawFaintLines(const std::vector<ScreenLine>& lines, double pen,
                    const LinearColor& color, Image* image);

// How a mark is drawn, and its name in the legend.
struct MarkStyle {
  std::string name;
  LinearColor color;
  // Whether it is a dashed ring instead of a dot.
  bool is_hidden = false;
};

// Marks visible points with dots and hidden ones with dashed rings. Points are
// in samples; those off the screen are left out. Returns the styles that
// occurred.
std::vector<MarkStyle> DrawMarks(const std::string& name,
                                 const LinearColor& color,
                                 const std::vector<Vector3>& points,
                                 const VisibilityBuffer& buffer, Image* image);

// Writes the marks' names below the picture.
void DrawMarkLegend(const std::vector<MarkStyle>& styles, Image* image);

// Writes a title above the picture.
void DrawPictureTitle(const std::string& title, Image* image);

// The size of letters in a picture of this size, in pixels.
double TextSize(int picture_width, int picture_height);

// Width of the key at the right, in pixels. 0 if the picture is too narrow for
// one.
double KeyWidth(int picture_width, int picture_height);

// Draws the colours of 0 to `largest` in a bar under `title`, with `isolines`
// or, if there are none, with lines at `levels`.
// REQUIRES: KeyWidth is not 0.
void DrawColorBar(const std::string& title, const Colormap& colormap,
                  const IsolineScale& isolines,
                  const std::vector<double>& levels, double largest,
                  Image* image);

// Draws a list of the sources' colours and names. Names, and the list, are cut
// where there is no room.
// REQUIRES: KeyWidth is not 0.
void DrawSourceColors(
    const std::vector<std::string>& names,
    const std::function<LinearColor(uint32_t source)>& color_of, Image* image);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_OVERLAY_H_
