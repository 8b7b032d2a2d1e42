// The scale beside a picture: colours, isolines and the distances they mean.

#ifndef GEODESIC_CLIENT_PICTURE_COLOR_BAR_H_
#define GEODESIC_CLIENT_PICTURE_COLOR_BAR_H_

#include <vector>

#include "client/picture/camera.h"
#include "client/picture/colormap.h"
#include "client/picture/image.h"
#include "client/picture/isolines.h"

namespace geodesic::client {

// Room the scale takes at the right of a picture of this size, in pixels.
double ColorBarWidth(int picture_width, int picture_height);

// Draws the scale of 0 to `largest` into that room, with `isolines` or, if it
// has none, lines at `levels`.
void DrawColorBar(const Colormap& colormap, const IsolineScale& isolines,
                  const std::vector<double>& levels, double largest,
                  LinearImage* image);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_COLOR_BAR_H_
