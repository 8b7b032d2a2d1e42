#include "tests/core/polygons/drawings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace geodesic::test {
namespace {

// Twice the area of a triangle; above 0 if it turns left.
double Turn(const Place& a, const Place& b, const Place& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool Meet(const Place& a, const Place& b, const Place& c, const Place& d) {
  return Turn(a, b, c) * Turn(a, b, d) <= 0 &&
         Turn(c, d, a) * Turn(c, d, b) <= 0;
}

Place Polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

Drawing Outline(std::vector<Place> places) {
  Drawing drawing{.places = std::move(places), .corners = {}};
  drawing.corners.resize(drawing.places.size());
  std::iota(drawing.corners.begin(), drawing.corners.end(), 0);
  return drawing;
}

double TwiceArea(const Drawing& drawing) {
  double sum = 0;
  for (size_t i = 0; i < drawing.corners.size(); ++i) {
    const Place& a = drawing.places[drawing.corners[i]];
    const Place& b =
        drawing.places[drawing.corners[(i + 1) % drawing.corners.size()]];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum;
}

bool SidesMeet(const Drawing& drawing) {
  const size_t n = drawing.corners.size();
  const auto at = [&](size_t i) {
    return drawing.places[drawing.corners[i % n]];
  };
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (Meet(at(i), at(i + 1), at(j), at(j + 1))) return true;
    }
  }
  return false;
}

Drawing Star(uint32_t spikes, Random& random) {
  std::vector<Place> places;
  for (uint32_t i = 0; i < 2 * spikes; ++i) {
    const double radius =
        i % 2 == 0 ? random.Uniform(0.5, 1) : random.Uniform(0.05, 0.2);
    places.push_back(Polar(radius, std::numbers::pi * i / spikes));
  }
  return Outline(std::move(places));
}

Drawing Comb(uint32_t teeth, Random& random) {
  std::vector<Place> places;
  for (uint32_t i = 0; i < teeth; ++i) {
    const double tip = random.Uniform(1.5, 9);
    places.insert(places.end(), {{4.0 * i, 1},
                                 {4.0 * i + 1, tip},
                                 {4.0 * i + 2, tip},
                                 {4.0 * i + 3, 1}});
  }
  places.insert(places.end(), {{4.0 * teeth, 0}, {0, 0}});
  std::ranges::reverse(places);
  return Outline(std::move(places));
}

Drawing Spiral(uint32_t turns, uint32_t corners) {
  std::vector<Place> places;
  const auto add = [&](uint32_t i, double shift) {
    const double turn = static_cast<double>(i) / corners;
    places.push_back(Polar(1 + turn + shift, 2 * std::numbers::pi * turn));
  };
  for (uint32_t i = 0; i <= turns * corners; ++i) add(i, 0.5);
  for (uint32_t i = turns * corners + 1; i-- > 0;) add(i, 0);
  return Outline(std::move(places));
}

Drawing Tangle(uint32_t count, Random& random) {
  std::vector<Place> places(count);
  for (Place& place : places) {
    place = {random.Uniform(-1, 1), random.Uniform(-1, 1)};
  }
  // Turning a stretch round between two sides that cross makes the whole
  // shorter, so it comes to an end.
  for (bool is_tangled = true; is_tangled;) {
    is_tangled = false;
    for (uint32_t i = 0; i < count; ++i) {
      for (uint32_t j = i + 2; j < count; ++j) {
        if ((j + 1) % count == i || !Meet(places[i], places[i + 1], places[j],
                                          places[(j + 1) % count])) {
          continue;
        }
        std::reverse(places.begin() + i + 1, places.begin() + j + 1);
        is_tangled = true;
      }
    }
  }
  return Outline(std::move(places));
}

Drawing Sieve(uint32_t n) {
  Drawing sieve{.places = {{-1, -1}}, .corners = {0}};
  const auto add = [&sieve](double x, double y) {
    sieve.places.push_back({x, y});
    sieve.corners.push_back(static_cast<int64_t>(sieve.places.size()) - 1);
  };
  // Row by row, the highest first, which comes next behind the left side: over
  // the holes to the right, and back below them. Holes turn right.
  for (uint32_t row = n; row-- > 0;) {
    const double y = 3.0 * row;
    const int64_t first = static_cast<int64_t>(sieve.places.size());
    for (uint32_t column = 0; column < n; ++column) {
      const double x = 3.0 * column;
      add(x, y);
      add(x, y + 1);
      add(x + 1, y + 1);
      add(x + 1, y);
    }
    for (uint32_t column = n; column-- > 0;) {
      if (column + 1 < n) sieve.corners.push_back(first + 4 * column + 3);
      sieve.corners.push_back(first + 4 * column);
    }
    sieve.corners.push_back(0);
  }
  const double end = 3.0 * n;
  add(end, -1);
  add(end, end);
  add(-1, end);
  return sieve;
}

Drawing TouchingSieve(uint32_t n) {
  // Squares along a diagonal, each from corner to corner; the first one's
  // corner is the outline's, and the last one's lies on a side of it.
  const double end = 2.0 * n;
  Drawing sieve{.places = {{0, 0}}, .corners = {0}};
  const auto add = [&sieve](double x, double y) {
    sieve.places.push_back({x, y});
    sieve.corners.push_back(static_cast<int64_t>(sieve.places.size()) - 1);
  };
  std::vector<int64_t> back;
  for (uint32_t i = 0; i < n; ++i) {
    const double x = 2.0 * i;
    // Up on the left sides of the holes.
    add(x + 0.5, x + 1.5);
    if (i + 1 < n) add(x + 2, x + 2);
  }
  add(end, end - 0.5);
  for (uint32_t i = n; i-- > 0;) {
    const double x = 2.0 * i;
    // Down on the right, by way of the corners that were passed.
    add(x + 1.5, x + 0.5);
    sieve.corners.push_back(i == 0 ? 0 : static_cast<int64_t>(2 * i));
  }
  add(end, 0);
  add(end, end + 1);
  add(0, end + 1);
  return sieve;
}

}  // namespace geodesic::test
