// Fast marching against planes, closed forms and the exact solver.

#include "geodesic/approximate/fast_marching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/core/approximate/method_check.h"
#include "tests/support/checkpoints.h"
#include "tests/support/meshes/crowded_meshes.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic::test {
namespace {

constexpr ApproximateMethod kBoth[] = {ApproximateMethod::kFmm,
                                       ApproximateMethod::kFmmUntidy};

// Rows of `steps` unit edges, each row `lean` to the left of the one below and
// `rise` above it.
TriangleSoup Lattice(uint32_t steps, double lean, double rise) {
  TriangleSoup soup =
      MakeGrid({.columns = steps, .rows = steps, .cell_height = rise});
  for (Point& p : soup.positions) p[0] -= lean / rise * p[1];
  return soup;
}

// A planar front with this direction enters over the boundary: all vertices of
// the outer `margin` rows are sources, with the offsets that it has there. How
// far off it is inside at the worst.
double WorstOffPlane(const TriangleSoup& soup, uint32_t steps, uint32_t margin,
                     ApproximateMethod method, double angle) {
  const auto mesh = BuildOrFail({"lattice", soup});
  const auto front = [&](uint32_t v) {
    const Point& p = soup.positions[v];
    // Beyond all that is negative.
    return 4.0 * steps + std::cos(angle) * p[0] + std::sin(angle) * p[1];
  };
  const auto is_source = [&](uint32_t v) {
    const uint32_t x = v % (steps + 1), y = v / (steps + 1);
    return std::min({x, y, steps - x, steps - y}) < margin;
  };
  std::vector<Source> sources;
  for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
    if (is_source(v)) sources.push_back({VertexPoint{v}, front(v)});
  }
  const std::vector<double> got =
      AskOrFail(*PrepareOrFail(*mesh, method), *mesh, sources);
  double worst = 0;
  for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
    worst = std::max(worst, std::abs(got[v] - front(v)));
  }
  return worst;
}

// Roundings of numbers of about 100.
constexpr double kRounding = 1e-12;

TEST(FastMarching, PlanarFrontsAreExactWithoutObtuseAngles) {
  for (const double lean : {0.5, 0.0}) {
    const TriangleSoup soup = Lattice(24, lean, 0.9);
    for (int i = 0; i < 32; ++i) {
      EXPECT_LE(WorstOffPlane(soup, 24, 1, ApproximateMethod::kFmm, 0.2 * i),
                kRounding)
          << "lean " << lean << ", angle " << 0.2 * i;
    }
  }
}

// All faces have an angle of 125 degrees; the outer three rows have angles that
// would have to be split beyond the boundary. Where nothing is split, fronts
// are off by up to 0.4 of an edge.
TEST(FastMarching, PlanarFrontsAreExactWhereObtuseAnglesAreSplit) {
  const TriangleSoup soup = Lattice(24, 1.3, 0.9);
  for (int i = 0; i < 32; ++i) {
    EXPECT_LE(WorstOffPlane(soup, 24, 3, ApproximateMethod::kFmm, 0.2 * i),
              kRounding)
        << "angle " << 0.2 * i;
  }
}

// The error that a front makes around its source is of order h log h: with
// edges of half the length, 0.72 of it here at first, 0.6 later.
TEST(FastMarching, ErrorsShrinkWithTheEdges) {
  for (const ApproximateMethod method : kBoth) {
    double before = 0;
    for (uint32_t levels = 2; levels <= 6; ++levels) {
      const auto mesh = BuildOrFail({"icosphere", Icosphere(levels)});
      const FieldErrors errors = CompareWithExact(
          *mesh, {{VertexPoint{0}}},
          AskOrFail(*PrepareOrFail(*mesh, method), *mesh, {{VertexPoint{0}}}));
      if (before > 0) {
        EXPECT_LE(errors.mean, 0.8 * before) << levels;
      }
      before = errors.mean;
    }
    EXPECT_LE(before, 0.01);
  }
}

TEST(FastMarching, TheUntidyQueueIsOffByBucketsAtTheMost) {
  for (const TriangleSoup& soup :
       {Icosphere(5), Torus({.around = 200, .across = 50, .noise = 0.002})}) {
    const auto mesh = BuildOrFail({"surface", soup});
    const auto tidy = AskOrFail(*PrepareOrFail(*mesh, ApproximateMethod::kFmm),
                                *mesh, {{VertexPoint{5}}});
    const auto untidy =
        AskOrFail(*PrepareOrFail(*mesh, ApproximateMethod::kFmmUntidy), *mesh,
                  {{VertexPoint{5}}});
    const double h =
        std::ldexp(mesh->mean_edge_length(), mesh->scale_exponent());
    double worst = 0;
    for (uint32_t v = 0; v < tidy.size(); ++v) {
      worst = std::max(worst, std::abs(tidy[v] - untidy[v]));
    }
    EXPECT_LE(worst, h / 4);
  }
}

// A vertex hands on to all of its faces, and there may be very many of these.
TEST(FastMarching, AsksByFaces) {
  const auto mesh = BuildOrFail({"triangles", AllTriangles(60)});
  for (const auto method :
       {ApproximateMethod::kFmm, ApproximateMethod::kFmmUntidy}) {
    RecordingCheckpoint checkpoint;
    ASSERT_TRUE(PrepareOrFail(*mesh, method)
                    ->Distances(Valid(*mesh, {.sources = {{VertexPoint{0}}}}),
                                checkpoint)
                    .ok());
    EXPECT_GE(checkpoint.polls().size(), 3 * mesh->face_count() / 6000);
  }
}

TEST(FastMarching, SourcesHaveOffsets) {
  const auto mesh = BuildOrFail({"plane", Lattice(30, 0.5, 0.9)});
  for (const ApproximateMethod method : kBoth) {
    const std::vector<Source> sources = {
        {VertexPoint{0}, 3}, {VertexPoint{960}, 0.5}, {VertexPoint{500}, 1000}};
    const FieldErrors errors = CompareWithExact(
        *mesh, sources,
        AskOrFail(*PrepareOrFail(*mesh, method), *mesh, sources));
    EXPECT_LE(errors.mean, 0.04);
  }
}

}  // namespace
}  // namespace geodesic::test
