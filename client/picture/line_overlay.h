// Lines on the surface, drawn over the picture where they are seen.

#ifndef GEODESIC_CLIENT_PICTURE_LINE_OVERLAY_H_
#define GEODESIC_CLIENT_PICTURE_LINE_OVERLAY_H_

#include <vector>

#include "client/picture/image.h"
#include "client/picture/rasterizer.h"
#include "client/picture/vector3.h"

namespace geodesic::client {

// How much of each pixel is covered, 0 to 1. Strokes that overlap cover once.
class LineOverlay {
 public:
  LineOverlay(int width, int height) : coverage_(width, height, 0) {}

  // A straight stroke with round ends; all in pixels.
  void AddStroke(double x0, double y0, double x1, double y1, double pen);

  // The parts of a line on the surface that nothing hides, or all of them. The
  // points are in samples, of which a pixel has `samples_per_pixel` across, as
  // are those of `buffer`.
  enum class Parts { kVisible, kAll };
  void AddLine(const std::vector<Vector3>& points, Parts parts, double pen,
               int samples_per_pixel, const VisibilityBuffer& buffer);

  // Mixes the colour in, at most by `strength`.
  void Paint(const LinearColor& color, float strength,
             LinearImage* image) const;

 private:
  Raster<float> coverage_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_LINE_OVERLAY_H_
