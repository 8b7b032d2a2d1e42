// Fields and paths from places in bad faces: faces whose corners lie in a row,
// needles, doubled vertices. The two may never contradict each other.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "tests/core/questions/path_check.h"
#include "tests/support/field_check.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/oracles/brute_force.h"
#include "tests/support/random.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

TriangleSoup DrawMesh(uint64_t seed, Random& random) {
  TriangleSoup soup;
  switch (random.Below(4)) {
    case 2:
      soup = InsertZeroAreaFaces(Terrain(3, 3, 1, seed), 4, seed);
      break;
    case 3:
      soup = MakeGrid({.columns = 3,
                       .rows = 3,
                       .jitter = random.Below(2) ? 0.2 : 0,
                       .seed = seed});
      soup = InsertNeedles(InsertZeroAreaFaces(soup, 4, seed), 2, seed);
      break;
    default:
      soup = EditedMesh(seed, true);
  }
  return random.Below(2) ? RotateAndShift(soup, seed) : soup;
}

std::vector<uint32_t> BadFaces(const TriangleSoup& soup) {
  constexpr Real kHeight = 1e-6;  // over the longest edge
  std::vector<uint32_t> bad;
  for (uint32_t f = 0; f < soup.triangles.size(); ++f) {
    const auto& [a, b, c] = soup.triangles[f];
    const Vec3 p = ToVec3(soup.positions[a]), q = ToVec3(soup.positions[b]),
               r = ToVec3(soup.positions[c]);
    const Real longest = std::max({Norm(q - p), Norm(r - q), Norm(p - r)});
    if (Norm(Cross(q - p, r - p)) <= kHeight * longest * longest) {
      bad.push_back(f);
    }
  }
  return bad;
}

// At any scale from one of its corners.
SurfacePoint DrawPlace(const std::vector<uint32_t>& faces, Random& random) {
  FacePoint place{.face =
                      faces[random.Below(static_cast<uint32_t>(faces.size()))]};
  const uint32_t corner = random.Below(3);
  const double a = std::pow(10, random.Uniform(-18, -0.5));
  const double b = std::pow(10, random.Uniform(-18, -0.5));
  place.weights[(corner + 1) % 3] = a;
  place.weights[(corner + 2) % 3] = b;
  place.weights[corner] = 1 - a - b;
  return place;
}

// The field agrees with brute force, and every path is as long as it says.
void CheckDraw(uint64_t seed) {
  Random random(seed);
  const TriangleSoup soup = DrawMesh(seed, random);
  const std::vector<uint32_t> bad = BadFaces(soup);
  constexpr size_t kMostFaces = 120;
  if (bad.empty() || soup.triangles.size() > kMostFaces) return;
  const NamedMesh named{absl::StrCat("bad faces ", seed), soup};
  const auto mesh = BuildOrFail(named);
  const double slack = 4 * CoordinateRounding(soup.positions);
  std::vector<SurfacePoint> places;
  for (int i = 0; i < 4; ++i) places.push_back(DrawPlace(bad, random));
  constexpr uint64_t kMostWindows = 300'000;
  const BruteForce brute_force(soup, places, {}, kMostWindows);
  if (!brute_force.is_complete()) return;
  for (const SurfacePoint& place : places) {
    const AlgorithmInfo& info =
        kAlgorithms[random.Below(static_cast<uint32_t>(kAlgorithms.size()))];
    const Query query{
        .sources = {{place}}, .targets = places, .algorithm = info.algorithm};
    const DistanceField field = SolveTraced(*mesh, query);
    EXPECT_TRUE(FieldsAgree({named.name, query.sources, info.name},
                            brute_force.Distances(query.sources),
                            AllDistances(field), slack));
    CheckAllPaths(named.name, *mesh, query,
                  {.slack = slack, .check_bends = false});
  }
}

TEST(BadFaces, PathsAreAsLongAsDistances) {
  for (uint64_t seed = 0; seed < 500; ++seed) CheckDraw(seed);
  // Some that were wrong: a field shorter than straight through space, paths
  // through a corner beside the straight line, or round half the mesh.
  for (const uint64_t seed :
       {626, 731, 816, 943, 1674, 1713, 3231, 5613, 5936, 7023, 7371}) {
    CheckDraw(seed);
  }
}

// Of no length at all, between copies of a vertex that faces without area part;
// and where windows come round a ring of such faces, by rounding nearer.
TEST(BadFaces, PathsAcrossFacesOnOneLine) {
  const std::vector<Point> of_copies = {
      {0.5625, 1, 0.1875}, {0.75, 1, 0.25}, {0.515625, 1, 0.171875},
      {0, 1, 0},           {2, 1, 2},       {0.5625, 1, 0.1875}};
  const TriangleSoup copies = {of_copies,
                               {{0, 1, 2}, {1, 3, 2}, {1, 2, 4}, {3, 1, 5}}};
  const std::vector<Point> of_ring = {
      {1, 1, 1}, {1, 1.25, 1.25}, {1, 2, 2},
      {1, 2, 2}, {1, 1.75, 1.75}, {1, 1.1626309010264877, 1.1626309010264877},
      {1, 2, 2}};
  const TriangleSoup ring = {
      of_ring,
      {{0, 1, 2}, {3, 0, 4}, {5, 0, 2}, {3, 6, 0}, {0, 6, 4}, {0, 6, 1}}};
  for (const NamedMesh& named :
       std::vector<NamedMesh>{{"copies", copies}, {"ring", ring}}) {
    const auto mesh = BuildOrFail(named);
    for (const AlgorithmInfo& info : kAlgorithms) {
      for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
        CheckAllPaths(
            named.name + ", " + std::string(info.name) + ", " +
                std::to_string(v),
            *mesh, {.sources = {{VertexPoint{v}}}, .algorithm = info.algorithm},
            {.slack = 4 * CoordinateRounding(named.soup.positions),
             .check_bends = false});
      }
    }
  }
}

}  // namespace
}  // namespace geodesic::test
