// Distance -> colour, from deep violet over teal to yellow.
//
// The map is derived here, not taken from a table: a path through the OKLab
// colour space (B. Ottosson, "A perceptual color space for image processing",
// 2020) whose lightness only rises, walked at constant speed. Hence
//   1. equal steps of distance look equally large;
//   2. it keeps its order in greyscale and for colour-blind eyes.

#ifndef GEODESIC_CLIENT_PICTURE_COLORMAP_H_
#define GEODESIC_CLIENT_PICTURE_COLORMAP_H_

#include <array>

#include "client/picture/image.h"

namespace geodesic::client {

// A colour in OKLab: lightness 0 to 1, green-red and blue-yellow axes.
struct OkLab {
  double lightness = 0;
  double a = 0;
  double b = 0;
};

LinearColor LinearFromOkLab(const OkLab& color);

// Immutable, hence thread-safe.
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
