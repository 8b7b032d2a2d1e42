// Curves as sources: on planar meshes the distance to a polyline is that of
// Euclid to its segments.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/oracles/planar_oracles.h"

namespace geodesic::test {
namespace {

class Curves : public EveryAlgorithm {
 protected:
  // Checks the field of polylines and points with these offsets.
  void ExpectEuclid(const std::string& name, const TriangleSoup& soup,
                    const std::vector<PlanarCurve>& curves,
                    const std::vector<Source>& points = {}) const {
    const auto mesh = BuildOrFail({name, soup});
    Query query{.sources = points};
    for (const PlanarCurve& curve : curves) {
      query.sources.push_back(OnMesh(soup, curve));
    }
    // Points inside faces as targets.
    for (uint32_t f = 0; f < mesh->face_count(); f += 3) {
      query.targets.push_back(FacePoint{f, {0.5, 0.3, 0.2}});
      query.targets.push_back(
          EdgePoint{soup.triangles[f][0], soup.triangles[f][1], 0.25});
    }
    std::vector<double> expected;
    const auto expect = [&](const Point& p) {
      double least = std::numeric_limits<double>::infinity();
      for (const PlanarCurve& curve : curves) {
        least = std::min(least, DistanceTo(curve, p));
      }
      for (const Source& source : points) {
        const Point q = PositionOf(PointOf(source), *mesh);
        least = std::min(least,
                         source.offset + std::hypot(p[0] - q[0], p[1] - q[1]));
      }
      expected.push_back(least);
    };
    for (const Point& p : soup.positions) expect(p);
    for (const SurfacePoint& target : query.targets) {
      expect(PositionOf(target, *mesh));
    }
    ExpectAnswer(name, *mesh, query, expected, 1e-14);
  }
};

std::vector<std::pair<std::string, TriangleSoup>> Planes() {
  return {{"regular", MakeGrid({.columns = 12, .rows = 10})},
          {"jittered", MakeGrid({.columns = 12,
                                 .rows = 10,
                                 .diagonals = Diagonals::kRandom,
                                 .jitter = 0.24,
                                 .seed = 5})}};
}

TEST_P(Curves, AcrossFacesWithinOneAndAsASinglePoint) {
  for (const auto& [name, soup] : Planes()) {
    ExpectEuclid(name, soup, {{{{1.3, 2.1}, {9.7, 6.4}}}});
    ExpectEuclid(name, soup, {{{{2.2, 1.1}, {6.1, 7.3}, {10.3, 3.9}}}});
    ExpectEuclid(name, soup, {{{{5.6, 5.2}, {5.7, 5.3}}}});
    ExpectEuclid(name, soup, {{{{5.6, 5.2}}}});
  }
}

TEST_P(Curves, AlongEdgesAndThroughVertices) {
  const TriangleSoup soup = MakeGrid({.columns = 12, .rows = 10});
  // Along a row of edges, along diagonals, and along a face's own side in part.
  ExpectEuclid("row", soup, {{{{2, 4}, {9, 4}}}});
  ExpectEuclid("diagonal", soup, {{{{3, 2}, {7, 6}}}});
  ExpectEuclid("parts of edges", soup, {{{{2.25, 4}, {2.75, 4}}}});
  ExpectEuclid("closed", soup, {{{{3, 3}, {8, 3}, {8, 7}, {3, 7}, {3, 3}}}});
}

TEST_P(Curves, BesidePointsAndWithOffsets) {
  for (const auto& [name, soup] : Planes()) {
    // A point behind a curve that starts late: it wins in the middle, the curve
    // on both sides.
    ExpectEuclid(
        name, soup,
        {{{{1.2, 4.6}, {10.9, 4.9}}, 1.5}, {{{2, 8.2}, {3, 8.4}}, 0.2}},
        {{FacePoint{30, {0.2, 0.5, 0.3}}, 0.1}, {VertexPoint{6 + 13 * 3}, 0}});
  }
}

// An end very near a vertex knows the direction at right angles to the curve,
// where its own windows and the curve's meet, only roughly.
TEST_P(Curves, EndNearVertices) {
  const TriangleSoup soup =
      InsertZeroAreaFaces(MakeGrid({.columns = 8, .rows = 8}), 60, 2);
  const auto mesh = BuildOrFail({"grid", soup});
  constexpr uint32_t kGridVertices = 81;
  for (const double t : {1e-6, 1e-8, 1e-10}) {
    for (uint32_t f = 0; f < mesh->face_count(); f += 5) {
      const uint32_t a = soup.triangles[f][0], b = soup.triangles[f][1];
      if (std::max(a, b) >= kGridVertices) continue;
      const std::vector<double> field =
          SolveOn(*mesh, {{Curve{{EdgePoint{a, b, t}, VertexPoint{b}}}}});
      const Point start = PositionOf(EdgePoint{a, b, t}, *mesh);
      const Point& end = soup.positions[b];
      const PlanarCurve curve{{{start[0], start[1]}, {end[0], end[1]}}};
      for (uint32_t v = 0; v < field.size(); ++v) {
        EXPECT_NEAR(field[v], DistanceTo(curve, soup.positions[v]), 1e-9)
            << "from " << t << " of " << a << "-" << b << " to " << v;
      }
    }
  }
}

// A face given twice holds a curve twice: each sheet has it for its own.
TEST_P(Curves, RunInEveryFaceThatHoldsThem) {
  TriangleSoup soup = MakeGrid({.columns = 4, .rows = 4});
  const size_t faces = soup.triangles.size();
  for (size_t f = 0; f < faces; ++f)
    soup.triangles.push_back(soup.triangles[f]);
  const auto& [a, b, c] = soup.triangles[9];
  const auto mesh = BuildOrFail({"two sheets", soup});
  const EdgePoint start{a, b, 0.4};
  Query query = Ask({.sources = {{Curve{{start, VertexPoint{c}}}}}});
  for (uint32_t f = 0; f < mesh->face_count(); ++f) {
    query.targets.push_back(FacePoint{f, {0.5, 0.3, 0.2}});
  }
  const DistanceField field = SolveOrFail(*mesh, query);
  const Point from = PositionOf(start, *mesh), to = soup.positions[c];
  const PlanarCurve curve{{{from[0], from[1]}, {to[0], to[1]}}};
  for (uint32_t f = 0; f < mesh->face_count(); ++f) {
    EXPECT_NEAR(field.target_distances[f],
                DistanceTo(curve, PositionOf(query.targets[f], *mesh)), 1e-14)
        << "face " << f;
  }
}

// Distances from segments are sums of terms of both signs. Below 0, and
// improving by less than nothing for ever, they may come out where vertices
// coincide.
TEST_P(Curves, AreNowhereNearerThanTheirOffset) {
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    std::vector<uint32_t> doubled;
    const TriangleSoup soup =
        DoubleVertices(Terrain(5, 5, 1.5, seed), 6, seed, &doubled);
    const auto mesh = BuildOrFail({"doubled vertices", soup});
    for (uint32_t f = 0; f < mesh->face_count(); ++f) {
      const auto& [a, b, c] = soup.triangles[f];
      if (std::ranges::find_first_of(soup.triangles[f], doubled) ==
          soup.triangles[f].end()) {
        continue;
      }
      const Curve curve{{VertexPoint{c}, FacePoint{f, {0.38, 0.3, 0.32}},
                         EdgePoint{a, b, 0.58}, EdgePoint{b, c, 0.49},
                         EdgePoint{c, a, 0.95}}};
      const DistanceField field = SolveOrFail(
          *mesh, Ask({.sources = {{curve}}, .targets = curve.points}));
      for (const double d : field.distances) EXPECT_GE(d, 0) << seed;
      for (const double d : field.target_distances) {
        EXPECT_GE(d, 0) << seed;
        EXPECT_LE(d, 4 * CoordinateRounding(soup.positions)) << seed;
      }
    }
  }
}

GEODESIC_TEST_EVERY_ALGORITHM(Curves);

}  // namespace
}  // namespace geodesic::test
