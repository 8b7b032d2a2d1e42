// Evenly spaced distances: where isolines run and what the colour bar says.

#ifndef GEODESIC_CLIENT_PICTURE_ISOLINES_H_
#define GEODESIC_CLIENT_PICTURE_ISOLINES_H_

#include <string>
#include <vector>

namespace geodesic::client {

// Isolines at the multiples of `step`; every `per_label`-th is a thicker one
// whose distance the colour bar names.
struct IsolineScale {
  double step = 0;
  int per_label = 1;

  double label_step() const { return step * per_label; }
};

// Four to nine labels up to `largest`, at 1, 2 or 5 times a power of ten, with
// 16 to 45 isolines. No isolines (step 0) unless `largest` is positive and
// finite.
IsolineScale ChooseIsolines(double largest);

// How much of a point of the screen an isoline covers, 0 to 1. `distance` is
// the field there and `gradient` its change per pixel; lines are
// `width` pixels wide wherever they run, the labelled ones twice that. Where
// they would run closer than a few pixels they fade. There is none at distance
// zero.
double IsolineCoverage(const IsolineScale& scale, double distance,
                       double gradient, double width);

// The multiples of the label step from 0 to `largest`, as written beside the
// colour bar: "0", "0.5", "1", or "2e-05" where digits would run away.
struct ScaleLabel {
  double distance = 0;
  std::string text;
};
std::vector<ScaleLabel> ScaleLabels(const IsolineScale& scale, double largest);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_ISOLINES_H_
