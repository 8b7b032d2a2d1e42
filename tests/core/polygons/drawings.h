// Flat polygons to be cut, and what is known of them.

#ifndef GEODESIC_TESTS_CORE_POLYGONS_DRAWINGS_H_
#define GEODESIC_TESTS_CORE_POLYGONS_DRAWINGS_H_

#include <array>
#include <cstdint>
#include <vector>

#include "tests/support/random.h"

namespace geodesic::test {

using Place = std::array<double, 2>;

// Corners number places; those of a bridge come twice.
struct Drawing {
  std::vector<Place> places;
  std::vector<int64_t> corners;
};

// One corner a place.
Drawing Outline(std::vector<Place> places);

// Twice the area by the shoelace formula; above 0 if it turns left.
double TwiceArea(const Drawing& drawing);

// Whether two sides that share no corner cross, or one ends on another.
bool SidesMeet(const Drawing& drawing);

// Spikes of random lengths.
Drawing Star(uint32_t spikes, Random& random);
// Teeth of random lengths on a bar.
Drawing Comb(uint32_t teeth, Random& random);
// A band that winds inwards this many times, with `corners` a turn.
Drawing Spiral(uint32_t turns, uint32_t corners);
// Random places, joined so that no sides cross.
Drawing Tangle(uint32_t places, Random& random);
// A square with n x n square holes, each joined to the rest by a bridge, which
// the outline passes to and fro.
Drawing Sieve(uint32_t n);
// The same with holes that touch their neighbours in a corner, and the outline.
Drawing TouchingSieve(uint32_t n);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_CORE_POLYGONS_DRAWINGS_H_
