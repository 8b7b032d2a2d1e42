// Gradients and nearest sources.

#include "geodesic/field_quantities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/path.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/core/questions/path_check.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/oracles/planar_oracles.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

// The gradient at a vertex is the direction in which its shortest path arrives.
class GradientsTest : public EveryAlgorithm {
 protected:
  void Prepare(const NamedMesh& named, Query query) {
    mesh_ = BuildOrFail(named);
    query.trace = true;
    query_ = Ask(query);
    field_ = SolveTraced(*mesh_, query_);
    gradients_ = Gradients(*mesh_, Valid(*mesh_, query_), field_).value();
    ASSERT_EQ(gradients_.size(), mesh_->vertex_count());
  }

  // The last piece of the path to each vertex, unless it is too short to have a
  // direction, runs along the gradient.
  void ExpectAlongPaths(const NamedMesh& named, const Query& query) {
    Prepare(named, query);
    const PathTracer tracer = TracerOf(*mesh_, query_, field_);
    int compared = 0;
    for (uint32_t v = 0; v < gradients_.size(); ++v) {
      const Vec3 gradient = ToVec3(gradients_[v]);
      const GeodesicPath path = tracer.ToVertex(v).value();
      if (path.points.size() < 2) {
        EXPECT_EQ(Norm(gradient), 0) << named.name << " " << v;
        continue;
      }
      EXPECT_NEAR(static_cast<double>(Norm(gradient)), 1, 1e-14);
      const Vec3 last = ToVec3(path.positions.back()) -
                        ToVec3(path.positions[path.positions.size() - 2]);
      if (Norm(last) < 1e-4) continue;
      ++compared;
      const Real off = Norm((1 / Norm(last)) * last - gradient);
      EXPECT_LT(static_cast<double>(off), 1e-9) << named.name << " " << v;
    }
    EXPECT_GT(compared, mesh_->vertex_count() / 2);
  }

  // In a plane: away from the source, at which there is no direction.
  void ExpectAwayFrom(const Vec3& from, double tolerance) const {
    for (uint32_t v = 0; v < gradients_.size(); ++v) {
      const Vec3 away = ToVec3(mesh_->positions()[v]) - from;
      const Vec3 expected = Norm(away) > 0 ? (1 / Norm(away)) * away : Vec3{};
      EXPECT_LT(static_cast<double>(Norm(ToVec3(gradients_[v]) - expected)),
                tolerance)
          << v;
    }
  }

  std::shared_ptr<const Mesh> mesh_;
  Query query_;
  DistanceField field_;
  std::vector<Point> gradients_;
};

TEST_P(GradientsTest, PointAwayFromTheSourceInAPlane) {
  for (const double jitter : {0.0, 0.2}) {
    const TriangleSoup grid =
        MakeGrid({.columns = 12, .rows = 9, .jitter = jitter});
    const Triangle& face = grid.triangles[90];
    for (const SurfacePoint& point : std::vector<SurfacePoint>{
             VertexPoint{50}, EdgePoint{face[0], face[1], 0.3},
             FacePoint{90, {0.2, 0.3, 0.5}}}) {
      Prepare({"grid", grid}, {.sources = {{point, 3}}});
      ExpectAwayFrom(ToVec3(PositionOf(point, *mesh_)), 1e-12);
    }
  }
}

TEST_P(GradientsTest, RunAlongPaths) {
  ExpectAlongPaths(
      {"terrain", Terrain(14, 14, 3, 4)},
      {.sources = {{VertexPoint{100}}, {FacePoint{7, {0.2, 0.3, 0.5}}, 0.1}}});
  ExpectAlongPaths({"torus", Scale(Torus({.noise = 0.2}), 1e6)},
                   {.sources = {{VertexPoint{3}}}});
  ExpectAlongPaths({"U", MakeGrid(UShape({.columns = 9, .rows = 9}))},
                   {.sources = {{VertexPoint{4}}}});
  const TriangleSoup grid =
      MakeGrid({.columns = 12, .rows = 10, .jitter = 0.24, .seed = 5});
  ExpectAlongPaths(
      {"curve", grid},
      {.sources = {OnMesh(grid, {{{2.2, 1.1}, {6.1, 7.3}, {10.3, 3.9}}, 0})}});
}

// A step back along the gradient shortens the distance by its length.
TEST_P(GradientsTest, AreWhatDistanceGrowsBy) {
  const TriangleSoup soup = Torus({.around = 20, .across = 14, .noise = 0.1});
  Query query{.sources = {{VertexPoint{5}}}};
  Prepare({"torus", soup}, query);
  // Back within the face that the path arrives through, a little way.
  constexpr double kStep = 1e-3;
  std::vector<uint32_t> vertices;
  std::vector<double> steps;
  for (uint32_t v = 0; v < gradients_.size(); ++v) {
    if (field_.distances[v] < kStep) continue;
    for (const HalfEdge h : mesh_->Outgoing(v)) {
      // Solve back = s * (to - at) + t * (apex - at) in the plane.
      const Vec3 at = ToVec3(soup.positions[v]);
      const Vec3 a = ToVec3(soup.positions[mesh_->To(h)]) - at;
      const Vec3 b = ToVec3(soup.positions[mesh_->Apex(h)]) - at;
      const Vec3 back = Real{-kStep} * ToVec3(gradients_[v]);
      const Vec3 normal = Cross(a, b);
      if (std::abs(Dot(back, normal)) > 1e-9L * Norm(normal)) continue;
      const Real s = Dot(Cross(back, b), normal) / Dot(normal, normal);
      const Real t = Dot(Cross(a, back), normal) / Dot(normal, normal);
      if (s < 0 || t < 0 || s + t > 1) continue;
      FacePoint target{.face = mesh_->FaceOf(h)};
      target.weights[Next(h) % 3] = static_cast<double>(s);
      target.weights[Prev(h) % 3] = static_cast<double>(t);
      target.weights[h % 3] = static_cast<double>(1 - s - t);
      query.targets.push_back(target);
      vertices.push_back(v);
      break;
    }
  }
  // Paths along an edge may leave the face by rounding; most do not.
  ASSERT_GT(vertices.size(), mesh_->vertex_count() / 2);
  const DistanceField field = SolveTraced(*mesh_, query);
  for (size_t i = 0; i < vertices.size(); ++i) {
    EXPECT_NEAR(field.target_distances[i], field.distances[vertices[i]] - kStep,
                1e-10)
        << vertices[i];
  }
}

TEST_P(GradientsTest, AreZeroWhereNoPathArrives) {
  const TriangleSoup sphere = Icosphere(1);
  Prepare({"two spheres", Join(sphere, sphere)},
          {.sources = {{VertexPoint{3}}}});
  const size_t first = sphere.positions.size();
  EXPECT_EQ(gradients_[3], Point{});
  for (size_t v = 0; v < gradients_.size(); ++v) {
    EXPECT_EQ(gradients_[v] == Point{}, v >= first || v == 3) << v;
  }
}

// A double gets the direction of its original.
TEST_P(GradientsTest, PassThroughCoincidentVertices) {
  const TriangleSoup soup =
      DoubleVertices(MakeGrid({.columns = 9, .rows = 8}), 15, 3);
  Prepare({"doubled vertices", soup}, {.sources = {{VertexPoint{0}}}});
  ExpectAwayFrom(ToVec3(soup.positions[0]), 1e-9);
}

GEODESIC_TEST_EVERY_ALGORITHM(GradientsTest);

// The Voronoi label of a vertex names a source whose own field is least there.
class NearestSourcesTest : public EveryAlgorithm {
 protected:
  std::vector<uint32_t> Labels(const Mesh& mesh,
                               const std::vector<Source>& sources) const {
    const Query query = Ask({.sources = sources, .trace = true});
    return NearestSources(mesh, Valid(mesh, query), SolveTraced(mesh, query))
        .value();
  }

  void ExpectLeastFields(const NamedMesh& named,
                         const std::vector<Source>& sources) const {
    const auto mesh = BuildOrFail(named);
    const std::vector<uint32_t> labels = Labels(*mesh, sources);
    std::vector<std::vector<double>> fields;
    for (const Source& source : sources) {
      fields.push_back(SolveOn(*mesh, {source}));
    }
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      double least = std::numeric_limits<double>::infinity();
      for (const std::vector<double>& field : fields) {
        least = std::min(least, field[v]);
      }
      const uint32_t label = labels[v];
      if (std::isinf(least)) {
        EXPECT_EQ(label, kNoSource) << named.name << " " << v;
        continue;
      }
      ASSERT_LT(label, sources.size()) << named.name << " " << v;
      EXPECT_LE(fields[label][v], least * (1 + kRelativeTolerance))
          << named.name << " " << v;
    }
  }
};

TEST_P(NearestSourcesTest, AreThoseOfTheLeastField) {
  ExpectLeastFields({"grid", MakeGrid({.columns = 12, .rows = 12})},
                    {{VertexPoint{0}},
                     {VertexPoint{168}, 0.5},
                     {FacePoint{100, {0.25, 0.25, 0.5}}, 1},
                     {VertexPoint{12}}});
  ExpectLeastFields({"U", MakeGrid(UShape({.columns = 9, .rows = 9}))},
                    {{VertexPoint{3}}, {VertexPoint{40}}});
  const TriangleSoup torus = Torus({.around = 20, .across = 14, .noise = 0.15});
  const Triangle& face = torus.triangles[200];
  ExpectLeastFields({"torus", torus}, {{VertexPoint{5}},
                                       {EdgePoint{face[1], face[0], 0.3}, 0.1},
                                       {FacePoint{77, {0.2, 0.7, 0.1}}, 0.2},
                                       {VertexPoint{5}, 0.25}});
}

// A source whose offset is more than the way from another is nowhere nearest.
TEST_P(NearestSourcesTest, LeaveOutDominatedSources) {
  const auto mesh = BuildOrFail({"icosphere", Icosphere(1)});
  EXPECT_EQ(Labels(*mesh, {{VertexPoint{7}, 100}, {VertexPoint{30}}}),
            std::vector<uint32_t>(mesh->vertex_count(), 1));
}

// On a plane, where each curve's distance is Euclid's: a point between two of
// them.
TEST_P(NearestSourcesTest, AreNumberedAsTheyAreListed) {
  const TriangleSoup grid =
      MakeGrid({.columns = 12, .rows = 12, .jitter = 0.2, .seed = 3});
  const auto mesh = BuildOrFail({"grid", grid});
  const PlanarCurve low{{{1.3, 1.1}, {10.2, 1.9}}, 0.25};
  const PlanarCurve high{{{2.4, 9.7}, {6.1, 10.4}, {9.8, 8.2}}, 0};
  const std::vector<uint32_t> labels = Labels(
      *mesh,
      {OnMesh(grid, low), {VertexPoint{6 * 13 + 12}, 0.5}, OnMesh(grid, high)});
  std::vector<uint32_t> count(3);
  for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
    const Point& p = grid.positions[v];
    const std::vector<double> distances = {
        DistanceTo(low, p),
        0.5 + static_cast<double>(Distance(p, grid.positions[6 * 13 + 12])),
        DistanceTo(high, p)};
    const uint32_t label = labels[v];
    ASSERT_LT(label, 3u) << v;
    EXPECT_LE(distances[label],
              *std::ranges::min_element(distances) * (1 + kRelativeTolerance))
        << v;
    ++count[label];
  }
  for (const uint32_t vertices : count) EXPECT_GT(vertices, 0u);
}

TEST_P(NearestSourcesTest, AreNoneInOtherPieces) {
  const TriangleSoup sphere = Icosphere(1);
  ExpectLeastFields({"two spheres and a lone vertex",
                     AddIsolatedVertices(Join(sphere, sphere), 1)},
                    {{VertexPoint{3}}, {VertexPoint{11}}});
}

GEODESIC_TEST_EVERY_ALGORITHM(NearestSourcesTest);

TEST(FieldQuantities, SaySoWhenTheTraceIsMissingOrBroken) {
  const auto mesh = BuildOrFail({"icosphere", Icosphere(1)});
  const Query query{.sources = {{VertexPoint{0}}}, .trace = true};
  const ValidQuery valid = Valid(*mesh, query);
  DistanceField field = SolveTraced(*mesh, query);
  field.arrivals[1] = {.pseudo_source = 2};
  field.arrivals[2] = {.pseudo_source = 1};
  EXPECT_TRUE(absl::IsInternal(NearestSources(*mesh, valid, field).status()));
  field.arrivals.clear();
  EXPECT_TRUE(
      absl::IsInvalidArgument(NearestSources(*mesh, valid, field).status()));
  EXPECT_TRUE(absl::IsInvalidArgument(Gradients(*mesh, valid, field).status()));
}

}  // namespace
}  // namespace geodesic::test
