#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geodesic/solve.h"
#include "tests/stress/answers.h"
#include "tests/stress/laws.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/queries.h"
#include "tests/support/surface_points.h"
#include "tests/support/vec.h"

namespace geodesic::stress {
namespace {

using test::Random;
using test::Vec3;

// One point, its field, and how to say so.
struct Solved {
  Query query;
  std::vector<double> distances;  // of vertices, then of all points
};

Solved SolveFrom(const Scene& scene, const SurfacePoint& point,
                 Algorithm algorithm, Report& report) {
  Solved solved{.query = {.sources = {{point}},
                          .targets = scene.points,
                          .algorithm = algorithm}};
  solved.distances = AllDistances(*scene.mesh, solved.query, report);
  return solved;
}

Vec3 PositionAt(const Scene& scene, size_t i) {
  const size_t vertices = scene.soup.positions.size();
  return i < vertices
             ? test::ToVec3(scene.soup.positions[i])
             : test::PositionIn(scene.soup, scene.points[i - vertices]);
}

void CheckBounds(const Scene& scene, const Solved& solved, Report& report) {
  const Vec3 from =
      test::PositionIn(scene.soup, test::PointOf(solved.query.sources[0]));
  const auto holds = [&](size_t i) {
    const double straight =
        static_cast<double>(Norm(PositionAt(scene, i) - from));
    return solved.distances[i] >=
           straight * (1 - kTolerance) - 4 * scene.rounding;
  };
  report.CheckAll(solved.distances.size(), holds, "Euclid <= d",
                  Name(solved.query));
}

// From every point to every other and back, and by way of a third.
void CheckPairs(const Scene& scene, const std::vector<Solved>& from,
                const std::vector<size_t>& numbers, Report& report) {
  const size_t vertices = scene.soup.positions.size();
  const auto d = [&](size_t i, size_t j) {
    return from[i].distances[vertices + numbers[j]];
  };
  for (size_t i = 0; i < from.size(); ++i) {
    report.Check(d(i, i) <= 4 * scene.rounding, "d(s) = 0", d(i, i), ", ",
                 Name(from[i].query));
    for (size_t j = 0; j < i; ++j) {
      report.Check(AreEqual(d(i, j), d(j, i), 4 * scene.rounding),
                   "d(p, q) = d(q, p)", d(i, j), " and ", d(j, i), ", ",
                   Name(from[i].query), " and ", Name(from[j].query));
    }
    for (size_t j = 0; j < from.size(); ++j) {
      const auto holds = [&](size_t v) {
        return from[i].distances[v] <=
               (d(i, j) + from[j].distances[v]) * (1 + kTolerance) +
                   4 * scene.rounding;
      };
      report.CheckAll(from[i].distances.size(), holds, "triangle inequality",
                      Name(from[i].query), " by way of ", Name(from[j].query));
    }
  }
}

void CheckAgreement(const Scene& scene, const Solved& solved, Random& random,
                    Report& report) {
  // All on small scenes, one on others.
  std::vector<AlgorithmInfo> others = AlgorithmsFor(scene);
  if (!scene.is_small()) {
    others = {others[random.Below(static_cast<uint32_t>(others.size()))]};
  }
  for (const AlgorithmInfo& info : others) {
    Query query = solved.query;
    query.algorithm = info.algorithm;
    CheckEqual("algorithms agree", query, solved.distances,
               AllDistances(*scene.mesh, query, report), 4 * scene.rounding,
               report);
  }
  report.Check(
      AllDistances(*scene.mesh, solved.query, report) == solved.distances,
      "the same bits again", Name(solved.query));
}

// A point as a vertex of a finer mesh.
void CheckInsertion(const Scene& scene, const Solved& solved, Report& report) {
  test::Inserted inserted =
      test::InsertPoint(scene.soup, test::PointOf(solved.query.sources[0]));
  const absl::StatusOr<std::shared_ptr<const Mesh>> finer =
      Mesh::Build(std::move(inserted.soup));
  if (!report.Check(finer.ok(), "a point becomes a vertex", finer.status())) {
    return;
  }
  const Query query{.sources = {{VertexPoint{inserted.vertex}}},
                    .algorithm = solved.query.algorithm};
  std::vector<double> expected = AllDistances(**finer, query, report);
  expected.resize(scene.soup.positions.size());
  std::vector<double> got = solved.distances;
  got.resize(expected.size());
  CheckEqual("a point is as good as a vertex", solved.query, expected, got,
             16 * scene.rounding, report);
}

void CheckMotion(const Scene& scene, const Solved& solved, Random& random,
                 Report& report) {
  const double size = scene.size();
  TriangleSoup moved = scene.soup;
  for (Triangle& t : moved.triangles) std::swap(t[0], t[1]);
  if (size > 1e-3 && size < 1e3) {
    moved = test::RotateAndShift(std::move(moved), random.Below(1000));
  }
  const test::Relabelled relabelled = test::Relabel(moved, random.Below(1000));
  const auto* vertex =
      std::get_if<VertexPoint>(&test::PointOf(solved.query.sources[0]));
  if (vertex == nullptr) return;
  const absl::StatusOr<std::shared_ptr<const Mesh>> other =
      Mesh::Build(relabelled.soup);
  if (!report.Check(other.ok(), "a mesh moved and relabelled is one",
                    other.status())) {
    return;
  }
  const Query query{
      .sources = {{VertexPoint{relabelled.new_number[vertex->vertex]}}},
      .algorithm = solved.query.algorithm};
  const std::vector<double> got = AllDistances(**other, query, report);
  std::vector<double> expected(got.size());
  for (size_t v = 0; v < relabelled.new_number.size() && v < got.size(); ++v) {
    expected[relabelled.new_number[v]] = solved.distances[v];
  }
  CheckEqual("motion and relabelling change nothing", query, expected, got,
             64 * std::max(scene.rounding,
                           size > 1e-3 && size < 1e3 ? 4 * 0x1p-52 : 0.0),
             report);
}

}  // namespace

void CheckFieldLaws(const Scene& scene, Random& random, Report& report) {
  std::vector<Solved> from;
  std::vector<size_t> numbers;
  for (int i = 0; i < 3; ++i) {
    numbers.push_back(random.Below(static_cast<uint32_t>(scene.points.size())));
    from.push_back(SolveFrom(scene, scene.points[numbers.back()],
                             DrawAlgorithm(scene, random), report));
    if (from.back().distances.empty()) return;
  }
  for (const Solved& solved : from) {
    CheckBounds(scene, solved, report);
  }
  CheckPairs(scene, from, numbers, report);
  CheckAgreement(scene, from[0], random, report);
  CheckInsertion(scene, from[1], report);
  const Solved from_vertex =
      SolveFrom(scene, test::RandomVertexPoint(scene.soup, random),
                DrawAlgorithm(scene, random), report);
  CheckMotion(scene, from_vertex, random, report);
}

}  // namespace geodesic::stress
