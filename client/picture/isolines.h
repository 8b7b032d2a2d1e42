// Evenly spaced distances for isolines and for the labels of the colour bar.

#ifndef GEODESIC_CLIENT_PICTURE_ISOLINES_H_
#define GEODESIC_CLIENT_PICTURE_ISOLINES_H_

#include <string>
#include <vector>

namespace geodesic::client {

// Isolines run at the multiples of `step`. Every `per_label`-th is thicker, and
// the colour bar names its distance.
struct IsolineScale {
  double step = 0;
  int per_label = 1;

  double label_step() const { return step * per_label; }
};

// Four to nine labels up to `largest`, at 1, 2 or 5 times a power of ten, with
// 16 to 45 isolines. No isolines (step 0) unless `largest` is positive and
// finite.
IsolineScale ChooseIsolines(double largest);

// How much of a point of the screen an isoline covers, from 0 to 1. `distance`
// is the field there and `gradient` its change per pixel. Lines are `width`
// pixels wide everywhere, labelled ones twice that. They fade where they would
// be only a few pixels apart. There is no line at distance zero.
double IsolineCoverage(const IsolineScale& scale, double distance,
                       double gradient, double width);

// The multiples of the label step from 0 to `largest`, as written beside the
// colour bar: "0", "0.5", "1", or "2e-05" for very small or large ones.
struct ScaleLabel {
  double distance = 0;
  std::string text;
};
std::vector<ScaleLabel> ScaleLabels(const IsolineScale& scale, double largest);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_ISOLINES_H_
