// Maps distance to colour, from deep violet over teal to yellow.
//
// The map is a path through the OKLab colour space (B. Ottosson, "A perceptual
// color space for image processing", 2020). Its lightness only rises and its
// speed is constant. Therefore
//   1. equal steps of distance look equally large;
//   2. colours keep their order in greyscale and for colour-blind eyes.

#ifndef GEODESIC_CLIENT_PICTURE_COLORMAP_H_
#define GEODESIC_CLIENT_PICTURE_COLORMAP_H_

#include <array>

#include "client/picture/image.h"

namespace geodesic::client {

// A colour in OKLab: lightness from 0 to 1, and green-red and blue-yellow axes.
struct OkLab {
  double lightness = 0;
  double a = 0;
  double b = 0;
};

LinearColor LinearFromOkLab(const OkLab& color);

// Immutable and thread-safe.
class Colormap {
 public:
  Colormap();

  // The colour at `t`, clamped to 0..1.
  LinearColor At(double t) const;

 private:
  static constexpr int kEntries = 256;
  std::array<LinearColor, kEntries> entries_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_COLORMAP_H_
