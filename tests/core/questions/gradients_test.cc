// The gradient at a vertex is the direction in which its shortest path arrives.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/field_quantities.h"
#include "geodesic/path.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/core/questions/path_check.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/mesh_edits.h"
#include "tests/support/planar_curves.h"
#include "tests/support/planar_meshes.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

class GradientsTest : public EveryAlgorithm {
 protected:
  void Prepare(const NamedMesh& named, Query query) {
    mesh_ = BuildOrFail(named);
    ASSERT_NE(mesh_, nullptr);
    query.trace = true;
    query.algorithm = GetParam().algorithm;
    query_ = query;
    field_ = SolveTraced(*mesh_, query_);
    absl::StatusOr<std::vector<Point>> gradients =
        Gradients(*mesh_, Valid(*mesh_, query_), field_);
    ASSERT_TRUE(gradients.ok()) << gradients.status();
    ASSERT_EQ(gradients->size(), mesh_->vertex_count());
    gradients_ = *std::move(gradients);
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
      const Vec3 from = ToVec3(PositionOf(point, *mesh_));
      for (uint32_t v = 0; v < gradients_.size(); ++v) {
        const Vec3 away = ToVec3(grid.positions[v]) - from;
        const Vec3 expected = Norm(away) > 0 ? (1 / Norm(away)) * away : Vec3{};
        EXPECT_LT(static_cast<double>(Norm(ToVec3(gradients_[v]) - expected)),
                  1e-12)
            << v;
      }
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
  std::vector<uint32_t> doubled;
  const TriangleSoup soup =
      DoubleVertices(MakeGrid({.columns = 9, .rows = 8}), 15, 3, &doubled);
  Prepare({"doubled vertices", soup}, {.sources = {{VertexPoint{0}}}});
  for (uint32_t v = 1; v < gradients_.size(); ++v) {
    const Vec3 away = ToVec3(soup.positions[v]) - ToVec3(soup.positions[0]);
    if (Norm(away) == 0) continue;
    EXPECT_LT(static_cast<double>(
                  Norm(ToVec3(gradients_[v]) - (1 / Norm(away)) * away)),
              1e-9)
        << v;
  }
}

GEODESIC_TEST_EVERY_ALGORITHM(GradientsTest);

TEST(Gradients, SaySoWhenTheTraceIsMissing) {
  const std::shared_ptr<const Mesh> mesh =
      BuildOrFail({"icosphere", Icosphere(1)});
  ASSERT_NE(mesh, nullptr);
  const Query query{.sources = {{VertexPoint{0}}}, .trace = true};
  DistanceField field = SolveTraced(*mesh, query);
  field.arrivals.clear();
  EXPECT_TRUE(absl::IsInvalidArgument(
      Gradients(*mesh, Valid(*mesh, query), field).status()));
}

}  // namespace
}  // namespace geodesic::test
