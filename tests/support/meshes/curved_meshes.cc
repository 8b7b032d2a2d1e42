#include "tests/support/meshes/curved_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"
#include "tests/support/random.h"

namespace geodesic::test {
namespace {

constexpr double kPi = std::numbers::pi;

void PushOntoUnitSphere(TriangleSoup& soup) {
  for (Point& p : soup.positions) {
    const double norm = std::hypot(p[0], p[1], p[2]);
    for (double& coordinate : p) coordinate /= norm;
  }
}

}  // namespace

TriangleSoup Icosphere(uint32_t levels) {
  TriangleSoup soup = Triangulate(Icosahedron());
  PushOntoUnitSphere(soup);
  for (uint32_t i = 0; i < levels; ++i) {
    soup = SubdivideAtMidpoints(soup);
    PushOntoUnitSphere(soup);
  }
  return soup;
}

TriangleSoup UvSphere(uint32_t meridians, uint32_t bands) {
  TriangleSoup soup;
  soup.positions.push_back({0, 0, 1});
  for (uint32_t i = 1; i < bands; ++i) {
    const double polar = kPi * i / bands;
    for (uint32_t j = 0; j < meridians; ++j) {
      const double azimuth = 2 * kPi * j / meridians;
      soup.positions.push_back({std::sin(polar) * std::cos(azimuth),
                                std::sin(polar) * std::sin(azimuth),
                                std::cos(polar)});
    }
  }
  soup.positions.push_back({0, 0, -1});
  const uint32_t south = static_cast<uint32_t>(soup.positions.size() - 1);
  for (uint32_t j = 0; j < meridians; ++j) {
    const uint32_t next = (j + 1) % meridians;
    soup.triangles.push_back({0, 1 + j, 1 + next});
    for (uint32_t i = 0; i + 2 < bands; ++i) {
      const uint32_t upper = 1 + i * meridians, lower = upper + meridians;
      soup.triangles.push_back({upper + j, lower + j, lower + next});
      soup.triangles.push_back({upper + j, lower + next, upper + next});
    }
    const uint32_t last = south - meridians;
    soup.triangles.push_back({last + j, south, last + next});
  }
  return soup;
}

TriangleSoup Torus(const TorusOptions& options) {
  Random random(options.seed);
  TriangleSoup soup;
  for (uint32_t i = 0; i < options.around; ++i) {
    const double u = 2 * kPi * i / options.around;
    for (uint32_t j = 0; j < options.across; ++j) {
      const double v = 2 * kPi * j / options.across;
      const double r =
          options.major_radius + options.minor_radius * std::cos(v);
      Point p = {r * std::cos(u), r * std::sin(u),
                 options.minor_radius * std::sin(v)};
      for (double& c : p) c += random.Uniform(-options.noise, options.noise);
      soup.positions.push_back(p);
    }
  }
  for (uint32_t i = 0; i < options.around; ++i) {
    const uint32_t here = i * options.across;
    const uint32_t ahead = (i + 1) % options.around * options.across;
    for (uint32_t j = 0; j < options.across; ++j) {
      const uint32_t next = (j + 1) % options.across;
      soup.triangles.push_back({here + j, ahead + j, ahead + next});
      soup.triangles.push_back({here + j, ahead + next, here + next});
    }
  }
  return soup;
}

TriangleSoup Terrain(uint32_t columns, uint32_t rows, double roughness,
                     uint64_t seed) {
  TriangleSoup soup = MakeGrid({.columns = columns,
                                .rows = rows,
                                .diagonals = Diagonals::kRandom,
                                .jitter = 0.2,
                                .seed = seed});
  Random random(seed + 1);
  for (Point& p : soup.positions) p[2] = random.Uniform(0, roughness);
  return soup;
}

TriangleSoup Strip(uint32_t columns, double height, uint64_t seed) {
  TriangleSoup soup = MakeGrid({.columns = columns,
                                .rows = 1,
                                .diagonals = Diagonals::kRandom,
                                .seed = seed});
  std::ranges::sort(soup.triangles, {}, [&soup](const Triangle& t) {
    const std::vector<Point>& p = soup.positions;
    return p[t[0]][0] + p[t[1]][0] + p[t[2]][0];
  });
  Random random(seed + 1);
  for (Point& p : soup.positions) p[2] = random.Uniform(-height, height);
  return soup;
}

TriangleSoup HyperbolicGrid(uint32_t columns, uint32_t rows, double twist) {
  TriangleSoup soup = MakeGrid({.columns = columns, .rows = rows});
  for (Point& p : soup.positions) {
    p[0] -= columns / 2;
    p[1] -= rows / 2;
    p[2] = twist * p[0] * p[1];
  }
  return soup;
}

TriangleSoup SaddleRow(uint32_t saddles, double excess, uint32_t tail) {
  std::vector<double> xs;
  for (uint32_t i = 0; i <= saddles; ++i) xs.push_back(i);
  double step = 1, x = saddles;
  for (uint32_t i = 0; i < tail; ++i) {
    step *= 1.3;
    x += step;
    xs.push_back(std::round(x));
  }
  TriangleSoup soup;
  for (const double at : xs) {
    const double slope = std::sqrt(excess) * std::min<double>(at, saddles);
    for (const double y : {-1, 0, 1}) {
      soup.positions.push_back({at, y, slope * y});
    }
  }
  for (uint32_t i = 0; i + 1 < xs.size(); ++i) {
    for (const uint32_t a : {3 * i, 3 * i + 1}) {
      soup.triangles.push_back({a, a + 3, a + 4});
      soup.triangles.push_back({a, a + 4, a + 1});
    }
  }
  return soup;
}

TriangleSoup SaddleCluster(double excess, uint32_t rings, double ratio) {
  const double twist = std::sqrt(excess), lift = twist / 4;
  TriangleSoup soup;
  soup.positions = {{0, 0, 0},          {-0.5, 0, 0},       {0, 0.5, 0},
                    {0.5, 0, 0},        {0, -0.5, 0},       {0.5, 0.5, lift},
                    {-0.5, 0.5, -lift}, {0.5, -0.5, -lift}, {-0.5, -0.5, lift}};
  double size = 0.1;
  for (uint32_t k = 0; k < rings; ++k, size /= ratio) {
    soup.positions.push_back({0.25 + size, 0, 0});
    soup.positions.push_back({0.25, size, twist / 2 * size});
    soup.positions.push_back({0.25 - size, 0, 0});
    soup.positions.push_back({0.25, -size, -twist / 2 * size});
  }
  const auto centre = static_cast<uint32_t>(soup.positions.size());
  soup.positions.push_back({0.25, 0, 0});
  // West, north, east and south of the saddle, and the corners between.
  constexpr uint32_t kSaddle = 0, kW = 1, kN = 2, kE = 3, kS = 4, kNe = 5,
                     kNw = 6, kSe = 7, kSw = 8;
  // The corners of the outermost square.
  constexpr uint32_t kRight = 9, kTop = 10, kLeft = 11, kBottom = 12;
  soup.triangles = {
      {kSaddle, kNe, kN},      {kSaddle, kN, kNw},       {kSaddle, kNw, kW},
      {kSaddle, kW, kSw},      {kSaddle, kSw, kS},       {kSaddle, kS, kSe},
      {kSaddle, kLeft, kTop},  {kSaddle, kTop, kNe},     {kNe, kTop, kRight},
      {kNe, kRight, kE},       {kE, kRight, kSe},        {kRight, kBottom, kSe},
      {kBottom, kSaddle, kSe}, {kSaddle, kBottom, kLeft}};
  for (uint32_t ring = kRight; ring < centre; ring += 4) {
    for (uint32_t i = 0; i < 4; ++i) {
      const uint32_t a = ring + i, b = ring + (i + 1) % 4;
      if (ring + 4 == centre) {
        soup.triangles.push_back({a, b, centre});
        continue;
      }
      soup.triangles.push_back({a, b, b + 4});
      soup.triangles.push_back({a, b + 4, a + 4});
    }
  }
  return soup;
}

}  // namespace geodesic::test
