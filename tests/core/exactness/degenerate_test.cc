// Meshes on the edge of what is a mesh: faces without area, vertices on top of
// each other, pieces apart, single faces.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "geodesic/solve.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/checkpoints.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"
#include "tests/support/random.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class DegenerateMeshes : public EveryAlgorithm {};

TEST_P(DegenerateMeshes, SingleFace) {
  for (const auto& [name, positions] :
       std::vector<std::pair<std::string, std::vector<Point>>>{
           {"one face", {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}},
           {"one needle", {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}}},
           {"one face without area", {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}},
           {"one point three times", {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}}}) {
    ExpectEuclid({name, {positions, {{0, 1, 2}}}}, {0, 1, 2});
  }
}

// Straight lines that go through faces without area, through needles and
// through vertices at one place, and start in them.
TEST_P(DegenerateMeshes, BadFacesInAGrid) {
  for (const double jitter : {0.0, 0.2}) {
    for (const uint64_t seed : {1, 2, 3}) {
      const TriangleSoup grid =
          MakeGrid({.columns = 12, .rows = 10, .jitter = jitter, .seed = seed});
      std::vector<uint32_t> doubled;
      for (const NamedMesh& named : std::vector<NamedMesh>{
               {"zero-area faces", InsertZeroAreaFaces(grid, 40, seed)},
               {"needles", InsertNeedles(grid, 60, seed)},
               {"doubled", DoubleVertices(grid, 20, seed, &doubled)}}) {
        ExpectEuclid(named, SpreadVertices(named.soup, 12));
      }
      ASSERT_EQ(doubled.size(), 20);
    }
  }
}

// A face so thin that its height drowns in rounding.
TEST_P(DegenerateMeshes, NeedlesDownToRounding) {
  for (const double height : {1e-9, 1e-12, 1e-15, 1e-18, 1e-300}) {
    const TriangleSoup soup = {
        {{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}, {0.5, 1, 0}, {0.5, -1, 0}},
        {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {1, 0, 4}}};
    ExpectEuclid({absl::StrCat("needle of height ", height), soup},
                 {0, 1, 2, 3, 4});
  }
}

// Faces without area but for a noise of their corners, which no longer count as
// such: they lie whole in the gaps that vertices flat within rounding leave.
TEST_P(DegenerateMeshes, NoisyFacesWithoutArea) {
  for (const double noise : {3e-12, 1e-11, 1e-10}) {
    for (const uint64_t seed : {1, 3, 4}) {
      TriangleSoup soup =
          InsertZeroAreaFaces(MakeGrid({.columns = 8, .rows = 8}), 30, seed);
      Random random(seed);
      for (Point& p : soup.positions) {
        for (double& c : p) c += random.Uniform(-noise, noise);
      }
      const NamedMesh named{absl::StrCat("noise of ", noise), soup};
      const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
      for (const uint32_t s : SpreadVertices(soup, 6)) {
        const std::vector<double> field = SolveOn(*mesh, {{VertexPoint{s}}});
        for (uint32_t v = 0; v < field.size(); ++v) {
          // A step up and down by the noise is all that is longer than Euclid.
          EXPECT_NEAR(field[v],
                      static_cast<double>(
                          Distance(soup.positions[s], soup.positions[v])),
                      20 * noise)
              << named.name << ", seed " << seed << ", " << s << " to " << v;
        }
      }
    }
  }
}

// A face that is there twice is a sack, and rays go round one without area at
// no length: rounding must not make them nearer each time. The copy changes no
// distance, since every path through it may take the original.
TEST_P(DegenerateMeshes, WindowsDoNotGoRoundSacksForEver) {
  for (const uint64_t seed : {1, 2, 3}) {
    const TriangleSoup once = InsertZeroAreaFaces(
        DoubleVertices(Terrain(3, 3, 1, seed), 1, seed), 3, seed);
    TriangleSoup twice = once;
    twice.triangles.insert(twice.triangles.end(), once.triangles.begin(),
                           once.triangles.end());
    const std::shared_ptr<const Mesh> mesh = BuildOrFail({"twice", twice});
    const std::shared_ptr<const Mesh> original = BuildOrFail({"once", once});
    for (uint32_t f = 0; f < original->face_count(); f += 4) {
      const Query query = Ask({.sources = {{FacePoint{f, {0.2, 0.3, 0.5}}}}});
      test::WindowLimit checkpoint(500'000);
      const auto field = Solve(*mesh, query, {}, checkpoint);
      ASSERT_TRUE(field.ok()) << field.status() << ", seed " << seed;
      const auto expected = Solve(*original, query, {}, checkpoint);
      ASSERT_TRUE(expected.ok()) << expected.status();
      EXPECT_TRUE(FieldsAgree({"sacks", query.sources, GetParam().name},
                              expected->distances, field->distances,
                              4 * CoordinateRounding(once.positions)));
    }
  }
}

// The same round a vertex of hardly any angle, close to a source: distances at
// the vertex are less there than the rounding of a place on the edge.
TEST_P(DegenerateMeshes, WindowsDoNotGoRoundSpikesForEver) {
  // A needle, there twice, and a face through which the source sees it.
  const TriangleSoup soup = {
      {{-2.9550162213877655, 1.7609383355124615, -3.2770312019469272},
       {-2.4559909778145417, 1.7379631808282747, -3.4126598894785465},
       {-3.4473857569924897, 2.4673107224915443, -3.1842395457637878},
       {-3.2012009892150037, 2.1141245289943731, -3.2306353739083495}},
      {{0, 1, 2}, {2, 0, 3}, {2, 0, 3}}};
  const std::shared_ptr<const Mesh> mesh = BuildOrFail({"spike", soup});
  for (const double t : {1e-15, 1e-14, 1e-12, 1e-6}) {
    const Query query = Ask({.sources = {{EdgePoint{0, 1, t}}}});
    test::WindowLimit checkpoint(500'000);
    const auto field = Solve(*mesh, query, {}, checkpoint);
    ASSERT_TRUE(field.ok()) << field.status() << ", t " << t;
    const double length =
        static_cast<double>(Distance(soup.positions[0], soup.positions[1]));
    EXPECT_TRUE(
        FieldsAgree({"spike", query.sources, GetParam().name},
                    SolveOn(*mesh, {{VertexPoint{0}}}), field->distances,
                    t * length + 4 * CoordinateRounding(soup.positions)));
  }
}

// From faces without area that lead into each other in rings, a source sees
// across the edge on which they lie.
TEST_P(DegenerateMeshes, RingsOfFacesWithoutArea) {
  const std::vector<Point> corners = {{0, 0, 0},
                                      {-0.9528, -0.3036, 0},
                                      {0.2624, 0.0544, 0.1974},
                                      {-1.3916, -1.4366, 0}};
  using Triangles = decltype(TriangleSoup::triangles);
  const Triangles one_ring = {{3, 0, 5}, {3, 5, 0}, {1, 0, 3}, {5, 3, 0},
                              {2, 3, 1}, {4, 5, 0}, {0, 4, 3}};
  const Triangles three_rings = {{1, 0, 3}, {5, 4, 3}, {5, 4, 3}, {4, 0, 5},
                                 {3, 5, 4}, {2, 3, 1}, {4, 0, 3}, {3, 5, 4},
                                 {0, 4, 5}, {4, 0, 5}};
  for (const auto& [part, triangles] :
       std::vector<std::pair<double, Triangles>>{
           {0.951752439637819, one_ring}, {0.7768816627740744, three_rings}}) {
    TriangleSoup rings = {corners, triangles};
    for (const double t : {0.5, part}) {
      rings.positions.push_back({t * corners[3][0], t * corners[3][1], 0});
    }
    const std::vector<double> expected =
        SolveOn(*BuildOrFail({"two faces", {corners, {{1, 0, 3}, {3, 1, 2}}}}),
                {{EdgePoint{0, 3, part}}});
    const std::vector<double> got =
        SolveOn(*BuildOrFail({"rings", rings}), {{VertexPoint{5}}});
    for (uint32_t v = 0; v < expected.size(); ++v) {
      EXPECT_NEAR(got[v], expected[v], 8 * CoordinateRounding(rings.positions))
          << part << " to " << v;
    }
  }
}

// Two faces of a plane, and hundreds without area between points of one edge:
// what runs along them winds round their rings, each time a little farther.
TEST_P(DegenerateMeshes, HundredsOfRings) {
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    TriangleSoup soup = {{{0, 0, 0}, {4, 0, 0}, {0.5, 1.5, 0}, {3.5, 2, 0}},
                         {{2, 0, 1}, {3, 1, 2}}};
    std::vector<uint32_t> on_edge = {0, 1};
    while (on_edge.size() < 18) {
      on_edge.push_back(static_cast<uint32_t>(soup.positions.size()));
      soup.positions.push_back({random.Uniform(0, 4), 0, 0});
    }
    while (soup.triangles.size() < 288) {
      const auto corner = [&] { return on_edge[random.Below(on_edge.size())]; };
      const Triangle face = {corner(), corner(), corner()};
      if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) {
        soup.triangles.push_back(face);
      }
    }
    ExpectEuclid(
        {absl::StrCat("rings, seed ", seed), RotateAndShift(soup, seed)},
        {0, 1, 5, 19});
  }
}

TEST_P(DegenerateMeshes, PathsOnAFewFaces) {
  constexpr double kBend = 1e-5, kLong = 1e5;
  const std::vector<Point> squares = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                      {0, 1, 0}, {2, 1, 0}, {2, 2, 0},
                                      {1, 2, 0}};
  const std::vector<Point> long_faces = {
      {0, 0, 0},      {1, -kBend, 0}, {2, 0, 0},   {3, 0, 0},    {2, -kLong, 0},
      {3, -kLong, 0}, {0.4, 1, 0},    {1.2, 1, 0}, {0.5, -1, 0}, {1.5, -1, 0},
      {-1, 0, 0},     {-1, 1, 0},     {-1, 2, 0}};
  const std::vector<Triangle> behind_short_ones = {
      {0, 1, 6}, {6, 1, 7}, {1, 2, 7},   {1, 8, 9},
      {2, 4, 3}, {3, 4, 5}, {10, 11, 12}};
  const std::vector<Point> folds = {{5, 1, 1}, {6, 2, 0}, {5, 2, 1}, {6, 3, 0},
                                    {5, 3, 1}, {4, 3, 2}, {6, 4, 0}, {5, 4, 2}};
  const std::vector<Point> spoke = {{0, 1, -0.5},   {-2, 0, 0.75},
                                    {1, 0, 0.5},    {0, 0, 0},
                                    {-1, 0, 0.375}, {0, -2, -0.75}};
  const std::vector<NamedMesh> meshes = {
      // Every path between them bends in the vertex.
      {"two squares that touch",
       {squares, {{0, 1, 2}, {0, 2, 3}, {2, 4, 5}, {2, 5, 6}}}},
      // The path to (2, 0) is known first by way of the corner at (1, -1e-5),
      // where
      // faces touch, and then improves by 1e-10. That is much beside its own
      // length,
      // but the edges behind are 1e5 long: the newer window ties with the older
      // one
      // there (kLoopTie, for the face without area), and one of them has to
      // stay.
      {"long faces behind short ones", {long_faces, behind_short_ones}},
      // Around a face without area.
      {"strip of folds",
       {folds, {{0, 1, 2}, {2, 3, 4}, {5, 4, 3}, {6, 5, 3}, {6, 7, 5}}}},
      {"point on a spoke",
       {spoke, {{0, 1, 2}, {1, 3, 2}, {1, 4, 3}, {1, 5, 4}}}},
      {"doubled point on an edge",
       {{{0, 0, 0}, {1, 2, 0}, {2, 0, 0}, {1, -2, 0}, {1.5, 1, 0}, {1.5, 1, 0}},
        {{0, 2, 1}, {0, 3, 2}, {1, 4, 5}, {1, 2, 4}}}}};
  for (const NamedMesh& named : meshes) {
    ExpectBruteForce(named, SpreadVertices(named.soup, 7));
  }
}

// A sheet folded back on itself, whose faces are 1e-9 as high as they are long:
// windows miss vertices beside others. SolveOn expects that no vertex is
// farther than a neighbour and the way from there.
TEST_P(DegenerateMeshes, FoldedNeedlesAreNotLeftOut) {
  const std::vector<Triangle> folded = {
      {0, 4, 1}, {4, 5, 1}, {1, 5, 6}, {1, 6, 2},  {2, 6, 3},  {6, 7, 3},
      {4, 8, 5}, {8, 9, 5}, {5, 9, 6}, {9, 10, 6}, {6, 10, 7}, {10, 11, 7}};
  const std::shared_ptr<const Mesh> mesh = BuildOrFail(
      {"folded needles",
       {{{2.6020527637557096e-12, 0.0, 1.3224557146675526e-12},
         {2.6020527637557096e-12, 1.0000000000000002e-06,
          1.219195023046415e-12},
         {2.6020527637557096e-12, 0.002, 6.134515106222839e-13},
         {2.6020527637557096e-12, 0.003, 6.223801179322336e-13},
         {1.4029581843163721e-12, 0.0, 5.043130577450019e-13},
         {1.4029581843163721e-12, 1.0000000000000002e-06,
          2.2932754742924665e-13},
         {1.4029581843163721e-12, 0.002, 3.346693546402034e-13},
         {1.4029581843163721e-12, 3e-06, 1.1095460128885108e-13},
         {7.564380301417603e-13, 0.0, 7.058810844976104e-13},
         {7.564380301417603e-13, 0.001, 7.3567271875753e-13},
         {7.564380301417603e-13, 2.0000000000000003e-06, 5.675761100205648e-13},
         {7.564380301417603e-13, 0.003, 5.210236025582191e-15}},
        folded}});
  for (uint32_t source = 0; source < mesh->vertex_count(); ++source) {
    SCOPED_TRACE(absl::StrCat("from ", source));
    SolveOn(*mesh, {{VertexPoint{source}}});
  }
}

TEST_P(DegenerateMeshes, OtherPiecesAreInfinitelyFar) {
  const TriangleSoup box = BoxGrid(1, 1, 1, 3, 3, 3);
  const uint32_t first = static_cast<uint32_t>(box.positions.size());
  const NamedMesh named{"two boxes and lone vertices",
                        AddIsolatedVertices(Join(box, box), 3)};
  const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
  const std::vector<double> field = SolveOn(*mesh, {{VertexPoint{4}}});
  ASSERT_EQ(field.size(), 2 * first + 3);
  for (uint32_t v = 0; v < first; ++v) EXPECT_LT(field[v], 3) << v;
  for (uint32_t v = first; v < field.size(); ++v) {
    EXPECT_EQ(field[v], kInfinity) << v;
  }
  // A lone vertex is at 0 from itself and infinitely far from all else.
  const std::vector<double> lone =
      SolveOn(*mesh, {{VertexPoint{2 * first + 1}}});
  for (uint32_t v = 0; v < lone.size(); ++v) {
    EXPECT_EQ(lone[v], v == 2 * first + 1 ? 0 : kInfinity) << v;
  }
  // A source in each piece: the fields do not mix.
  const std::vector<double> both =
      SolveOn(*mesh, {{VertexPoint{4}}, {VertexPoint{first + 4}, 0.25}});
  for (uint32_t v = 0; v < first; ++v) {
    EXPECT_NEAR(both[v], field[v], 1e-14) << v;
    EXPECT_NEAR(both[first + v], field[v] + 0.25, 1e-14) << v;
  }
}

// A slit from the middle to the rim: the same segment twice, on either side of
// a gap without width. Paths across bend at its tip.
TEST_P(DegenerateMeshes, PathsGoRoundASlit) {
  TriangleSoup soup = MakeGrid({.columns = 8, .rows = 8});
  constexpr uint32_t kTip = 4 * 9 + 4;  // (4, 4); doubles from (4, 5) on
  const uint32_t first_double = static_cast<uint32_t>(soup.positions.size());
  for (uint32_t y = 5; y <= 8; ++y) {
    soup.positions.push_back({4, static_cast<double>(y), 0});
  }
  const auto is_right = [&](uint32_t v) {
    return v >= first_double || v % 9 > 4;
  };
  for (Triangle& t : soup.triangles) {
    if (std::none_of(t.begin(), t.end(), is_right)) continue;
    for (uint32_t& v : t) {
      if (v % 9 == 4 && v > kTip) v = first_double + v / 9 - 5;
    }
  }
  const auto distance = [&](uint32_t s, uint32_t v) {
    const Point &p = soup.positions[s], &q = soup.positions[v];
    const Point& tip = soup.positions[kTip];
    bool direct = is_right(s) == is_right(v);
    if (!direct && p[0] != q[0]) {
      const double t = (tip[0] - p[0]) / (q[0] - p[0]);
      direct = p[1] + t * (q[1] - p[1]) <= tip[1];
    }
    return static_cast<double>(direct ? Distance(p, q)
                                      : Distance(p, tip) + Distance(tip, q));
  };
  ExpectDistances({"slit grid", soup},
                  {0, 8, kTip, kTip + 9, 9 * 8 + 4, first_double + 3, 9 * 7},
                  distance);
}

GEODESIC_TEST_EVERY_ALGORITHM(DegenerateMeshes);

}  // namespace
}  // namespace geodesic::test
