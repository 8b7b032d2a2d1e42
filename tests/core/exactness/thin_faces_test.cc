// Beside faces that are hardly higher than rounding, windows may miss vertices.
// Fields reach these along edges in the end; searches, and fields that stop at
// a target or a radius, must not answer before.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "geodesic/computation.h"
#include "geodesic/mesh.h"
#include "geodesic/target_search.h"
#include "geodesic/triangle_soup.h"
#include "tests/support/field_check.h"
#include "tests/support/meshes/needle_meshes.h"
#include "tests/support/oracles/brute_force.h"
#include "tests/support/queries.h"
#include "tests/support/random.h"

namespace geodesic::test {
namespace {

// A ribbon that winds in the plane, or almost, squeezed to a line.
TriangleSoup SqueezedSpiral(Random& random, double thinnest) {
  const uint32_t length = 2 + random.Below(18);
  const double turns = random.Uniform(0.5, 6);
  const double growth = random.Uniform(0, 0.3);
  const double width = random.Uniform(0.1, 6) * growth;
  const double squeezed = random.OfAnySize(thinnest, 1e3 * thinnest);
  const double rise = random.Below(2) * random.OfAnySize(thinnest, 1);
  TriangleSoup soup;
  for (uint32_t i = 0; i <= length; ++i) {
    const double angle = 2 * std::numbers::pi * turns * i / length;
    for (const double beside : {0.0, width}) {
      const double radius = 1 + growth * angle + beside;
      soup.positions.push_back({radius * std::cos(angle),
                                squeezed * radius * std::sin(angle),
                                rise * angle});
    }
    if (i == 0) continue;
    const uint32_t a = 2 * i - 2, b = a + 1, c = a + 2, d = a + 3;
    if (random.Below(2) == 0) {
      soup.triangles.push_back({a, c, b});
      soup.triangles.push_back({b, c, d});
    } else {
      soup.triangles.push_back({a, c, d});
      soup.triangles.push_back({a, d, b});
    }
  }
  return soup;
}

// A closed fan whose sides have next to no angle at its tip.
TriangleSoup FoldedCone(Random& random, double thinnest) {
  const uint32_t sides = 5 + random.Below(12);
  const double radius = random.OfAnySize(thinnest, 1e3 * thinnest);
  TriangleSoup soup{.positions = {{0, 0, 0}}};
  for (uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    const double along = random.Uniform(1, 1.5);
    soup.positions.push_back({along * radius * std::cos(angle),
                              along * radius * std::sin(angle) / 10, along});
    soup.triangles.push_back({0, i + 1, (i + 1) % sides + 1});
  }
  return soup;
}

NamedMesh ThinMesh(uint32_t seed) {
  Random random(seed);
  const double thinnest = random.OfAnySize(1e-10, 1e-7);
  const bool is_cone = seed % 8 == 0;
  return {absl::StrCat("thin mesh ", seed),
          is_cone ? FoldedCone(random, thinnest)
                  : SqueezedSpiral(random, thinnest)};
}

// Windows alone miss vertices on some of 100,000 such meshes, and among others
// on these: in searches, and in fields that stop.
constexpr uint32_t kMissed[] = {952,   1800,  2480,  2736,  3808,  5352, 5392,
                                6504,  7120,  7408,  4307,  5172,  7026, 9806,
                                11273, 15126, 15173, 16123, 21087, 23465};

std::vector<NamedMesh> ThinMeshes() {
  std::vector<NamedMesh> meshes;
  for (uint32_t seed = 0; seed < 500; ++seed) meshes.push_back(ThinMesh(seed));
  for (const uint32_t seed : kMissed) meshes.push_back(ThinMesh(seed));
  return meshes;
}

// Some roundings of coordinates, which are about 1 to 12: no distance is better
// known.
constexpr double kSlack = 1e-13;

void ExpectNear(double expected, double got, const std::string& what) {
  if (expected == got) return;  // infinite, perhaps
  EXPECT_NEAR(expected, got, kRelativeTolerance * expected + kSlack) << what;
}

TEST(ThinFaces, SearchesFindWhatFieldsSay) {
  NoCheckpoint checkpoint;
  for (const NamedMesh& named : ThinMeshes()) {
    const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
    TargetSearch search(*mesh);
    const Query from{.sources = {{VertexPoint{mesh->vertex_count() / 2}}}};
    const std::vector<double> field = SolveOrFail(*mesh, from).distances;
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      Query query = from;
      query.targets = {VertexPoint{v}};
      const auto found = search.Run(Valid(*mesh, query), nullptr, checkpoint);
      ASSERT_TRUE(found.ok()) << found.status() << named.name;
      ExpectNear(field[v], found->distances[0],
                 absl::StrCat(named.name, ", vertex ", v));
    }
  }
}

TEST(ThinFaces, FieldsThatStopSayWhatWholeFieldsSay) {
  NoCheckpoint checkpoint;
  for (const NamedMesh& named : ThinMeshes()) {
    const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
    const Query from{.sources = {{VertexPoint{mesh->vertex_count() / 3}}}};
    const std::vector<double> field = SolveOrFail(*mesh, from).distances;
    for (uint32_t v = 0; v < mesh->vertex_count(); v += 3) {
      Query to_v = from;
      to_v.targets = {VertexPoint{v}};
      for (const bool at_target : {true, false}) {
        const std::unique_ptr<Computation> computation =
            StartComputation(*mesh, Valid(*mesh, to_v), {}).value();
        const Reach reach =
            at_target ? Reach{.targets = 1} : Reach{.radius = field[v]};
        ASSERT_TRUE(computation->Advance(reach, checkpoint).ok());
        const DistanceField stopped = computation->Field();
        ExpectNear(field[v], stopped.target_distances[0], named.name);
        for (uint32_t w = 0; w < mesh->vertex_count(); ++w) {
          const bool is_settled =
              field[w] <
              stopped.settled_radius * (1 - kRelativeTolerance) - kSlack;
          if (!is_settled && std::isinf(stopped.distances[w])) continue;
          ExpectNear(
              field[w], stopped.distances[w],
              absl::StrCat(named.name, ", stopped for ", v, ", vertex ", w));
        }
      }
    }
  }
}

// Nor does it matter what else is asked for.
TEST(ThinFaces, WaysBackAreAsLong) {
  for (uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    const bool is_book = seed % 2 == 0;
    const NamedMesh named{
        absl::StrCat(is_book ? "book of needles " : "rows of needles ", seed),
        is_book ? NeedleBook(random) : NeedleRows(random)};
    const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
    const SurfacePoint source = PointBesideCorner(*mesh, random);
    Query query{.sources = {{source}}};
    const std::vector<double> alone = SolveOrFail(*mesh, query).distances;
    for (int i = 0; i < 4; ++i) {
      query.targets.push_back(PointBesideCorner(*mesh, random));
    }
    const DistanceField field = SolveOrFail(*mesh, query);
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      ExpectNear(field.distances[v], alone[v],
                 absl::StrCat(named.name, ", vertex ", v));
    }
    for (uint32_t t = 0; t < query.targets.size(); ++t) {
      const DistanceField back = SolveOrFail(
          *mesh, {.sources = {{query.targets[t]}}, .targets = {source}});
      ExpectNear(field.target_distances[t], back.target_distances[0],
                 absl::StrCat(named.name, ", target ", t));
    }
  }
}

// A search said that there is no path.
TEST(ThinFaces, StripOfFourNeedles) {
  const TriangleSoup soup{
      .positions = {{1, 0, 0},
                    {1.99, 0, 0},
                    {-3.4801334562949919, 2.2482677195974149e-06, 0},
                    {-4.4431740700393325, 2.8704200455739494e-06, 0},
                    {5.4937848383072225, -7.525527657879e-06, 0},
                    {6.3774155932992969, -8.735947774749528e-06, 0}},
      .triangles = {{0, 2, 3}, {0, 3, 1}, {2, 4, 3}, {4, 5, 3}}};
  const std::shared_ptr<const Mesh> mesh = BuildOrFail({"strip", soup});
  const BruteForce oracle(soup);
  TargetSearch search(*mesh);
  NoCheckpoint checkpoint;
  for (uint32_t from = 0; from < 6; ++from) {
    const std::vector<double> expected = oracle.Distances(from);
    for (uint32_t to = 0; to < 6; ++to) {
      const Query query{.sources = {{VertexPoint{from}}},
                        .targets = {VertexPoint{to}}};
      const auto found = search.Run(Valid(*mesh, query), nullptr, checkpoint);
      ASSERT_TRUE(found.ok()) << found.status();
      ExpectNear(expected[to], found->distances[0],
                 absl::StrCat(from, " to ", to));
    }
  }
}

}  // namespace
}  // namespace geodesic::test
