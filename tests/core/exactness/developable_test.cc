// Cones, saddle fans, prisms and folded sheets against their closed forms.

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/developable_meshes.h"

namespace geodesic::test {
namespace {

constexpr double kPi = std::numbers::pi;

class DevelopableMeshes : public EveryAlgorithm {
 protected:
  template <typename Surface>
  void ExpectClosedForm(const std::string& name, const Surface& surface) const {
    ExpectDistances(
        {name, surface.soup()}, SpreadVertices(surface.soup(), 6),
        [&](uint32_t s, uint32_t v) { return surface.Distance(s, v); });
  }
};

// From sharp cones over the flat disc to deep saddles. At the angles that are
// multiples of pi, shortest paths run exactly through the apex.
TEST_P(DevelopableMeshes, Fans) {
  for (const double angle :
       {0.3, 2.0, kPi, 5.5, 2 * kPi - 1e-7, 2 * kPi, 2 * kPi + 1e-7,
        2 * kPi + 1e-3, 7.0, 3 * kPi, 4 * kPi, 20.0}) {
    for (const bool closed : {true, false}) {
      for (const uint32_t spokes : {8u, 24u}) {
        const Fan fan({.spokes = spokes,
                       .rings = 5,
                       .total_angle = angle,
                       .closed = closed});
        ExpectClosedForm(absl::StrCat(closed ? "closed" : "open", " fan of ",
                                      spokes, " sectors, angle ", angle),
                         fan);
      }
    }
  }
}

// An apex with very many faces, as the tip of a fine cone has.
TEST_P(DevelopableMeshes, FanOfManySpokes) {
  ExpectClosedForm("cone of 600 sectors",
                   Fan({.spokes = 600, .rings = 2, .total_angle = 5}));
  ExpectClosedForm("saddle fan of 600 sectors",
                   Fan({.spokes = 600, .rings = 2, .total_angle = 15}));
}

TEST_P(DevelopableMeshes, Prisms) {
  for (const uint32_t sides : {3u, 4u, 7u, 12u}) {
    ExpectClosedForm(absl::StrCat("prism of ", sides, " sides"),
                     Prism({.sides = sides, .rows = 20}));
    ExpectClosedForm(absl::StrCat("low prism of ", sides, " sides"),
                     Prism({.sides = sides, .rows = 9, .row_height = 0.05}));
  }
}

TEST_P(DevelopableMeshes, FoldedSheets) {
  for (const uint64_t seed : {1, 2, 3}) {
    ExpectClosedForm("folded sheet", FoldedSheet(25, 18, seed));
  }
}

GEODESIC_TEST_EVERY_ALGORITHM(DevelopableMeshes);

}  // namespace
}  // namespace geodesic::test
