#include "tests/support/curved_meshes.h"

#include <cmath>
#include <numbers>

#include "tests/support/mesh_edits.h"
#include "tests/support/planar_meshes.h"
#include "tests/support/polyhedra.h"
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

}  // namespace geodesic::test
