// Polygons that are not convex: triangles cover their inside, once.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/checkpoint.h"
#include "geodesic/polygons.h"
#include "geodesic/triangle_soup.h"
#include "tests/core/polygons/drawings.h"
#include "tests/support/checkpoints.h"
#include "tests/support/random.h"
#include "tests/support/vec.h"

namespace geodesic {
namespace {

using test::Drawing;
using test::Outline;
using test::Place;
using test::Random;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Vector = std::array<double, 3>;

TriangleSoup Cut(const std::vector<Point>& positions,
                 const std::vector<int64_t>& corners) {
  const int64_t size = static_cast<int64_t>(corners.size());
  auto soup = TriangulatePolygons(positions, corners, {&size, 1});
  EXPECT_TRUE(soup.ok()) << soup.status();
  if (!soup.ok()) return {};
  EXPECT_EQ(soup->triangles.size(), corners.size() - 2);
  return *std::move(soup);
}

TriangleSoup Cut(const std::vector<Point>& positions) {
  std::vector<int64_t> corners(positions.size());
  std::iota(corners.begin(), corners.end(), 0);
  return Cut(positions, corners);
}

// Where a drawing lies in space.
struct Plane {
  Vector origin = {0, 0, 0};
  Vector x = {1, 0, 0};
  Vector y = {0, 1, 0};

  Point At(const Place& place) const {
    Point point;
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] = origin[axis] + place[0] * x[axis] + place[1] * y[axis];
    }
    return point;
  }
  Vector Normal() const { return Cross(x, y); }
  static Vector Cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0]};
  }
};

Plane RandomPlane(Random& random) {
  Plane plane;
  const auto unit = [&] {
    Vector v;
    double norm = 0;
    while (norm < 0.1) {
      for (double& part : v) part = random.Uniform(-1, 1);
      norm = std::hypot(v[0], v[1], v[2]);
    }
    for (double& part : v) part /= norm;
    return v;
  };
  plane.origin = unit();
  plane.x = unit();
  plane.y = Plane::Cross(plane.x, unit());
  const double norm = std::hypot(plane.y[0], plane.y[1], plane.y[2]);
  for (double& part : plane.y) part /= norm;
  return plane;
}

std::vector<Point> PlacedIn(const Plane& plane, const Drawing& drawing) {
  std::vector<Point> positions;
  for (const Place& place : drawing.places)
    positions.push_back(plane.At(place));
  return positions;
}

// Twice the area of a triangle, seen along the normal.
double TwiceArea(const TriangleSoup& soup, const Triangle& triangle,
                 const Vector& normal) {
  const Point& p = soup.positions[triangle[0]];
  Vector a, b;
  for (int axis = 0; axis < 3; ++axis) {
    a[axis] = soup.positions[triangle[1]][axis] - p[axis];
    b[axis] = soup.positions[triangle[2]][axis] - p[axis];
  }
  const Vector cross = Plane::Cross(a, b);
  return cross[0] * normal[0] + cross[1] * normal[1] + cross[2] * normal[2];
}

// As sets of corners, in order.
std::vector<Triangle> Sorted(std::vector<Triangle> triangles) {
  for (Triangle& triangle : triangles) std::ranges::sort(triangle);
  std::ranges::sort(triangles);
  return triangles;
}

// Triangles that are turned as their polygon is, and have its area in sum, lie
// beside each other inside it: they wind around each point as often as the
// polygon does.
void ExpectCovered(const Drawing& drawing, const Plane& plane) {
  const double area = test::TwiceArea(drawing);
  const TriangleSoup soup = Cut(PlacedIn(plane, drawing), drawing.corners);
  ASSERT_EQ(soup.reading.crossing_polygons, 0);
  double sum = 0;
  for (const Triangle& triangle : soup.triangles) {
    const double own =
        TwiceArea(soup, triangle, plane.Normal()) * (area > 0 ? 1 : -1);
    ASSERT_GE(own, -1e-12 * std::abs(area));
    sum += own;
  }
  // The rounding of ten thousand triangles.
  EXPECT_NEAR(sum, std::abs(area), 1e-10 * std::abs(area));
}

// For all first corners, both ways round, and in space.
void ExpectCoveredAnyhow(Drawing drawing, Random& random) {
  const size_t step = 1 + drawing.corners.size() / 50;
  for (int way = 0; way < 2; ++way) {
    std::vector<Triangle> wanted;
    for (size_t i = 0; i < drawing.corners.size(); i += step) {
      ExpectCovered(drawing, {});
      ExpectCovered(drawing, RandomPlane(random));
      if (::testing::Test::HasFatalFailure()) return;
      const auto triangles =
          Sorted(Cut(PlacedIn({}, drawing), drawing.corners).triangles);
      if (i == 0) wanted = triangles;
      ASSERT_EQ(triangles, wanted) << "from corner " << i;
      std::rotate(drawing.corners.begin(), drawing.corners.begin() + step,
                  drawing.corners.end());
    }
    std::ranges::reverse(drawing.corners);
  }
}

Drawing Ell() {
  return Outline({{2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 0}});
}

TEST(CutPolygonsTest, AnElHasItsArea) {
  Random random(1);
  ASSERT_EQ(test::TwiceArea(Ell()), 2 * 3);
  ExpectCoveredAnyhow(Ell(), random);
}

TEST(CutPolygonsTest, StarsCombsAndSpirals) {
  Random random(2);
  for (uint32_t n = 3; n < 12; ++n) {
    SCOPED_TRACE(n);
    ExpectCoveredAnyhow(test::Star(n, random), random);
    ExpectCoveredAnyhow(test::Comb(n, random), random);
    ExpectCoveredAnyhow(test::Spiral(n, 5), random);
  }
}

TEST(CutPolygonsTest, AnyOutline) {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(round);
    const Drawing drawing = test::Tangle(4 + random.Below(20), random);
    ASSERT_FALSE(test::SidesMeet(drawing));
    // Convex ones are fans, which depend on the first corner.
    ExpectCovered(drawing, {});
    ExpectCovered(drawing, RandomPlane(random));
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(CutPolygonsTest, BridgesToHoles) {
  Random random(4);
  for (uint32_t n = 1; n < 5; ++n) {
    SCOPED_TRACE(n);
    const Drawing sieve = test::Sieve(n);
    ASSERT_EQ(test::TwiceArea(sieve),
              2 * ((3.0 * n + 1) * (3 * n + 1) - n * n));
    ExpectCoveredAnyhow(sieve, random);
  }
}

TEST(CutPolygonsTest, OutlinesThatTouchThemselves) {
  Random random(5);
  for (uint32_t n = 1; n < 8; ++n) {
    SCOPED_TRACE(n);
    ExpectCoveredAnyhow(test::TouchingSieve(n), random);
  }
}

TEST(CutPolygonsTest, ManyCorners) {
  Random random(6);
  ExpectCovered(test::Star(10'000, random), RandomPlane(random));
  ExpectCovered(test::Comb(5'000, random), RandomPlane(random));
  ExpectCovered(test::Spiral(50, 200), RandomPlane(random));
  ExpectCovered(test::Sieve(40), RandomPlane(random));
}

// Those of today: from the first corner.
std::vector<Triangle> Fan(const std::vector<int64_t>& corners) {
  std::vector<Triangle> fan;
  for (size_t i = 2; i < corners.size(); ++i) {
    fan.push_back({static_cast<uint32_t>(corners[0]),
                   static_cast<uint32_t>(corners[i - 1]),
                   static_cast<uint32_t>(corners[i])});
  }
  return fan;
}

TEST(CutPolygonsTest, ConvexPolygonsAreFans) {
  Random random(7);
  for (int round = 0; round < 200; ++round) {
    // Corners on a circle, and some on the sides between them.
    std::vector<double> angles(3 + random.Below(9));
    for (double& angle : angles) {
      angle = random.Uniform(0, 2 * std::numbers::pi);
    }
    std::ranges::sort(angles);
    std::vector<Place> places;
    for (size_t i = 0; i < angles.size(); ++i) {
      const Place a = {std::cos(angles[i]), std::sin(angles[i])};
      const double next = angles[(i + 1) % angles.size()];
      const Place b = {std::cos(next), std::sin(next)};
      const uint32_t parts = 1 + random.Below(3);
      for (uint32_t part = 0; part < parts; ++part) {
        const double t = static_cast<double>(part) / parts;
        places.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
      }
    }
    Drawing drawing = Outline(std::move(places));
    for (const bool is_reversed : {false, true}) {
      if (is_reversed) std::ranges::reverse(drawing.corners);
      const TriangleSoup soup =
          Cut(PlacedIn(RandomPlane(random), drawing), drawing.corners);
      ASSERT_EQ(soup.triangles, Fan(drawing.corners)) << round;
      ASSERT_EQ(soup.reading.crossing_polygons, 0);
    }
  }
}

// Seen from above, corner 2 of the first is reflex, however it is raised: only
// the diagonal from there leaves both triangles turned as the whole. The second
// is convex from above, and not a plane.
TEST(CutPolygonsTest, QuadrilateralsThatBend) {
  for (const double height : {-0.3, 0.0, 0.3}) {
    const std::vector<Point> arrow = {
        {0, 0, 0}, {4, 0, 0}, {1, 1, height}, {0, 4, 0}};
    EXPECT_EQ(Sorted(Cut(arrow).triangles), Sorted({{0, 1, 2}, {0, 2, 3}}));
    const std::vector<Point> turned = {arrow[1], arrow[2], arrow[3], arrow[0]};
    EXPECT_EQ(Sorted(Cut(turned).triangles), Sorted({{3, 0, 1}, {3, 1, 2}}));
    EXPECT_THAT(
        Cut({{0, 0, 0}, {1, 0, height}, {1, 1, 0}, {0, 1, height}}).triangles,
        ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  }
}

// What is told is a fan.
void ExpectCrossing(const Drawing& drawing) {
  Random random(8);
  for (const Plane& plane : {Plane{}, RandomPlane(random)}) {
    const TriangleSoup soup = Cut(PlacedIn(plane, drawing), drawing.corners);
    EXPECT_EQ(soup.reading.crossing_polygons, 1);
    EXPECT_EQ(soup.triangles, Fan(drawing.corners));
  }
}

TEST(CutPolygonsTest, CrossingPolygonsAreTold) {
  // A bow tie, without an area in sum; another one with.
  ExpectCrossing(Outline({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
  ExpectCrossing(Outline({{0, 0}, {1, 1}, {1, 0}, {0, 3}}));
  // A pentagram turns left everywhere, but goes round twice.
  std::vector<Place> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * std::numbers::pi * 2 * i / 5;
    star.push_back({std::cos(angle), std::sin(angle)});
  }
  ExpectCrossing(Outline(star));
  // The same square twice.
  ExpectCrossing({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {0, 1, 2, 3, 0, 1, 2, 3}});
  // To and fro, without an inside.
  ExpectCrossing({{{0, 0}, {1, 0}, {1, 1}}, {0, 1, 2, 1}});
  // Ten eighths of a ring: its ends lie on each other, and no sides cross.
  Drawing ring;
  for (const double radius : {2.0, 1.0}) {
    for (int i = 0; i < 8; ++i) {
      const double angle = std::numbers::pi * i / 4;
      ring.places.push_back(
          {radius * std::cos(angle), radius * std::sin(angle)});
    }
  }
  for (int i = 0; i <= 10; ++i) ring.corners.push_back(i % 8);
  for (int i = 10; i >= 0; --i) ring.corners.push_back(8 + i % 8);
  ExpectCrossing(ring);
  // Once around a ring is a bridge.
  std::erase_if(ring.corners, [n = 0](int64_t) mutable {
    const int at = n++;
    return at > 8 && at < 13;
  });
  ASSERT_EQ(ring.corners.size(), 18);
  ExpectCovered(ring, {});
}

TEST(CutPolygonsTest, RandomCrossingsAreTold) {
  Random random(9);
  int crossing = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<Place> places(5 + random.Below(4));
    for (Place& place : places) {
      place = {random.Uniform(-1, 1), random.Uniform(-1, 1)};
    }
    const Drawing drawing = Outline(std::move(places));
    const TriangleSoup soup = Cut(PlacedIn({}, drawing), drawing.corners);
    ASSERT_EQ(soup.reading.crossing_polygons, test::SidesMeet(drawing))
        << round;
    crossing += static_cast<int>(soup.reading.crossing_polygons);
  }
  EXPECT_GT(crossing, 100);
  EXPECT_LT(crossing, 490);
}

TEST(CutPolygonsTest, PolygonsAreNumbered) {
  const std::vector<Point> square = {
      {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  // A triangle, a square, two bow ties and a triangle.
  const auto soup =
      TriangulatePolygons(square,
                          std::vector<int64_t>{0, 1, 2, 0, 1, 2, 3, 0, 2, 1, 3,
                                               0, 2, 3, 1, 0, 2, 3},
                          std::vector<int64_t>{3, 4, 4, 4, 3});
  ASSERT_TRUE(soup.ok()) << soup.status();
  EXPECT_EQ(soup->reading.crossing_polygons, 2);
  EXPECT_EQ(soup->reading.first_crossing_polygon, 2);
  EXPECT_THAT(
      soup->triangles,
      ElementsAre(Triangle{0, 1, 2}, Triangle{0, 1, 2}, Triangle{0, 2, 3},
                  Triangle{0, 2, 1}, Triangle{0, 1, 3}, Triangle{0, 2, 3},
                  Triangle{0, 3, 1}, Triangle{0, 2, 3}));
}

TEST(CutPolygonsTest, CornersOnALineAreLeft) {
  for (const std::vector<int64_t>& corners :
       {std::vector<int64_t>{0, 1, 2, 3}, {0, 2, 1, 3, 1}, {0, 0, 0, 0}}) {
    const TriangleSoup soup =
        Cut({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {3, 6, 9}}, corners);
    EXPECT_EQ(soup.triangles, Fan(corners));
    EXPECT_EQ(soup.reading.crossing_polygons, 0);
  }
}

// Of k corners there are k - 2 triangles, so that faces keep their numbers.
TEST(CutPolygonsTest, CornersThatComeTwiceInARow) {
  Drawing ell = Ell();
  ell.corners = {5, 0, 0, 1, 2, 2, 2, 3, 4, 5};
  const TriangleSoup soup = Cut(PlacedIn({}, ell), ell.corners);
  ExpectCovered(ell, {});
  std::vector<Triangle> proper, wanted = Cut(PlacedIn({}, Ell())).triangles;
  for (const Triangle& t : soup.triangles) {
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) proper.push_back(t);
  }
  EXPECT_EQ(Sorted(proper), Sorted(wanted));
  EXPECT_EQ(soup.triangles.size(), 8);
}

// Vertices of their own at one place, as files with seams have them.
TEST(CutPolygonsTest, VerticesAtOnePlace) {
  Drawing ell = Ell();
  ell.places.insert(ell.places.begin() + 3, {1, 1});
  Random random(10);
  ExpectCoveredAnyhow(Outline(ell.places), random);
}

TEST(CutPolygonsTest, NoNumberIsTooLarge) {
  constexpr double kMost = std::numeric_limits<double>::max();
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  // Whatever comes of these.
  for (const double unit : {kLeast, 4 * kLeast, kNone, kInfinite}) {
    Cut(PlacedIn({.x = {unit, 0, 0}, .y = {0, unit, 0}}, Ell()));
  }
  const double large = kMost / 4;
  for (const double unit : {1e-300, 1e300, large}) {
    const TriangleSoup soup =
        Cut(PlacedIn({.x = {unit, 0, 0}, .y = {0, unit, 0}}, Ell()));
    EXPECT_EQ(Sorted(soup.triangles),
              Sorted(Cut(PlacedIn({}, Ell())).triangles))
        << unit;
  }
}

TEST(CutPolygonsTest, TheCheckpointStopsIt) {
  Random random(11);
  const Drawing star = test::Star(2'000, random);
  const std::vector<Point> positions = PlacedIn({}, star);
  const int64_t size = static_cast<int64_t>(star.corners.size());
  test::RecordingCheckpoint counts;
  ASSERT_TRUE(
      TriangulatePolygons(positions, star.corners, {&size, 1}, &counts).ok());
  const size_t polls = counts.polls().size();
  // More often than for each stage of the work.
  EXPECT_GT(polls, 20);
  for (size_t poll = 0; poll < polls; poll += 1 + polls / 20) {
    test::RecordingCheckpoint stopper(poll);
    EXPECT_TRUE(absl::IsCancelled(
        TriangulatePolygons(positions, star.corners, {&size, 1}, &stopper)
            .status()))
        << poll;
    EXPECT_EQ(stopper.polls().size(), poll + 1) << "asked again";
  }
}

TEST(TriangulatePolygonsTest, BadNumbersAreNamed) {
  const std::vector<Point> square = {
      {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto message = [&](const std::vector<int64_t>& corners,
                           const std::vector<int64_t>& sizes) {
    const auto soup = TriangulatePolygons(square, corners, sizes);
    EXPECT_TRUE(absl::IsInvalidArgument(soup.status()));
    return std::string(soup.status().message());
  };
  EXPECT_EQ(message({0, 1, 2, 0, 1}, {3, 2}),
            "face 1 has 2 corners; at least 3 are needed");
  EXPECT_EQ(message({0, 1, 2}, {4}), "face 0 has 4 corners, but 3 are left");
  for (const auto& [vertex, name] : {std::pair<int64_t, std::string>{4, "4"},
                                     {-1, "-1"},
                                     {int64_t{1} << 32, "4294967296"}}) {
    EXPECT_EQ(message({0, 1, vertex}, {3}),
              "face 0 names vertex " + name +
                  ", but there are 4 vertices, counted from 0");
  }
}

}  // namespace
}  // namespace geodesic
