// The shadow behind a vertex, against angles added up face by face.

#include "solver/rules/shadow_fan.h"

#include <absl/strings/str_cat.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "geodesic/mesh.h"
#include "geodesic/triangle_soup.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic {
namespace {

constexpr double kPi = std::numbers::pi;

double AngleAt(const Mesh& mesh, HalfEdge h) {
  return std::atan2(mesh.frame(h).apex_y, mesh.frame(h).apex_x);
}

// Half-edges that leave v counterclockwise, from the boundary if there is one.
std::vector<HalfEdge> Around(const Mesh& mesh, uint32_t v) {
  HalfEdge h = mesh.Outgoing(v)[0];
  for (const HalfEdge other : mesh.Outgoing(v)) {
    if (mesh.IsBoundaryEdge(other)) h = other;
  }
  std::vector<HalfEdge> around;
  for (const HalfEdge first = h; h != kNoHalfEdge;) {
    around.push_back(h);
    h = mesh.Twin(Prev(h));
    if (h == first) break;
  }
  return around;
}

// The angle at v from half-edge h to a point of the opposite edge.
double AngleTo(const Mesh& mesh, HalfEdge h, double at) {
  const HalfEdgeFrame& frame = mesh.frame(h);
  return std::atan2(at * frame.right_y, frame.length + at * frame.right_x);
}

// A ray that arrives at `angle` counterclockwise from around[0].
struct Ray {
  IncomingRay ray;
  double angle;
};

std::vector<Ray> RaysInto(const Mesh& mesh,
                          const std::vector<HalfEdge>& around) {
  std::vector<Ray> rays;
  double angle = 0;
  for (const HalfEdge h : around) {
    rays.push_back({IncomingRay::Along(h), angle});
    const HalfEdge opposite = Next(h);
    const HalfEdgeFrame& frame = mesh.frame(opposite);
    for (const double part : {0.1, 0.5, 0.8}) {
      const double at = part * frame.length;
      // As if the pseudo-source were on the edge itself.
      const Origin origin{.x = at, .depth = kLeastHeight};
      rays.push_back({RayThrough(opposite, origin, ApexOf(frame)),
                      angle + AngleTo(mesh, h, at)});
    }
    angle += AngleAt(mesh, h);
  }
  return rays;
}

void ExpectShadows(const Mesh& mesh, uint32_t v) {
  const std::vector<HalfEdge> around = Around(mesh, v);
  double total = 0;
  for (const HalfEdge h : around) total += AngleAt(mesh, h);
  const bool is_closed = !mesh.IsBoundary(v);
  for (const Ray& ray : RaysInto(mesh, around)) {
    std::vector<double> seen(mesh.half_edge_count(), 0);
    ShadowFan(mesh, v, ray.ray)
        .ForEachFace([&](HalfEdge h, const Interval& part) {
          EXPECT_EQ(mesh.From(h), v);
          seen[h] += AngleTo(mesh, h, part.end) - AngleTo(mesh, h, part.begin);
        });
    double begin = 0;
    for (const HalfEdge h : around) {
      const double end = begin + AngleAt(mesh, h);
      // What of [begin, end] lies at least pi from the ray, either way round.
      const auto beyond = [&](double low, double high) {
        return std::max(0.0, std::min(end, high) - std::max(begin, low));
      };
      double expected = 0;
      if (is_closed) {
        for (const double turn : {-total, 0.0, total}) {
          expected +=
              beyond(ray.angle + kPi + turn, ray.angle + total - kPi + turn);
        }
      } else {
        expected = beyond(ray.angle + kPi, total) + beyond(0, ray.angle - kPi);
      }
      EXPECT_NEAR(seen[h], expected, 4 * kFanMargin)
          << "vertex " << v << ", ray " << ray.angle << ", half-edge " << h;
      begin = end;
    }
  }
}

TEST(ShadowFanTest, BehindSaddles) {
  const auto mesh =
      *Mesh::Build(test::Torus({.around = 10, .across = 6, .noise = 0.2}));
  int saddles = 0;
  for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
    if (!mesh->IsSaddle(v)) continue;
    ++saddles;
    ExpectShadows(*mesh, v);
  }
  EXPECT_GT(saddles, 10);
}

TEST(ShadowFanTest, BehindReflexCorners) {
  const auto mesh =
      *Mesh::Build(test::MakeGrid(test::WithHole({.columns = 9, .rows = 9})));
  int corners = 0;
  for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
    if (!mesh->IsPseudoSource(v) || mesh->IsNonManifold(v)) continue;
    ++corners;
    ExpectShadows(*mesh, v);
  }
  EXPECT_GT(corners, 3);
}

// Two needles that each take all but 1e-8 of half a turn, so that a ray through
// one of them comes along its edges.
TEST(ShadowFanTest, BehindNeedles) {
  const auto mesh =
      *Mesh::Build({{{0, 0, 0}, {-1, -1e-8, 0}, {1, -1e-8, 0}, {-1, 2e-8, 0}},
                    {{0, 1, 2}, {0, 2, 3}}});
  ExpectShadows(*mesh, 0);
}

// Six faces that make a spike of less than half a turn. A ray may come so that
// on one side of it more than pi is left, and less on the other.
TEST(ShadowFanTest, SpikesHaveNone) {
  TriangleSoup soup;
  constexpr int kFaces = 6;
  constexpr double kHeight = 1.77;  // six corners of 0.158 pi
  for (uint32_t i = 0; i < kFaces; ++i) {
    const double turn = 2 * kPi * i / kFaces;
    soup.positions.push_back({std::cos(turn), std::sin(turn), 0});
    soup.triangles.push_back({kFaces, i, (i + 1) % kFaces});
  }
  soup.positions.push_back({0, 0, kHeight});
  const auto mesh = *Mesh::Build(soup);
  const std::vector<HalfEdge> around = Around(*mesh, kFaces);
  ASSERT_EQ(around.size(), static_cast<size_t>(kFaces));
  for (const Ray& ray : RaysInto(*mesh, around)) {
    const auto walk = [&] {
      ShadowFan(*mesh, kFaces, ray.ray)
          .ForEachFace([&](HalfEdge h, const Interval&) {
            throw std::logic_error(absl::StrCat("half-edge ", h, " is seen"));
          });
    };
    EXPECT_NO_THROW(walk()) << "ray " << ray.angle;
  }
}

}  // namespace
}  // namespace geodesic
