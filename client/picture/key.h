// What stands at the right of a picture: which distance or which source each
// colour means.

#ifndef GEODESIC_CLIENT_PICTURE_KEY_H_
#define GEODESIC_CLIENT_PICTURE_KEY_H_

#include <functional>
#include <string>
#include <vector>

#include "client/picture/colormap.h"
#include "client/picture/image.h"
#include "client/picture/isolines.h"

namespace geodesic::client {

inline constexpr LinearColor kTextInk = {0.03F, 0.03F, 0.035F};

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

// The colours of nearest sources, by the sources' names; as many as there is
// room for.
// REQUIRES: KeyWidth is not 0.
void DrawSourceColors(
    const std::vector<std::string>& names,
    const std::function<LinearColor(uint32_t source)>& color_of, Image* image);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_KEY_H_
