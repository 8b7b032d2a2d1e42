#include <algorithm>
#include <cmath>
#include <vector>

#include "geodesic/field_quantities.h"
#include "geodesic/isolines.h"
#include "geodesic/log_map.h"
#include "geodesic/path.h"
#include "geodesic/solve.h"
#include "tests/stress/answers.h"
#include "tests/stress/laws.h"
#include "tests/stress/path_check.h"
#include "tests/support/queries.h"
#include "tests/support/surface_points.h"
#include "tests/support/vec.h"

namespace geodesic::stress {
namespace {

using stress::Name;
using test::Name;
using test::Random;
using test::Real;

void CheckPaths(const Scene& scene, const Query& query,
                const DistanceField& field, Random& random, Report& report) {
  const absl::StatusOr<PathTracer> tracer =
      PathTracer::Create(*scene.mesh, test::Valid(*scene.mesh, query), field);
  if (!report.Check(tracer.ok(), "a traced field has paths", tracer.status())) {
    return;
  }
  for (uint32_t t = 0; t < query.targets.size(); ++t) {
    CheckPath(scene, query, tracer->ToTarget(t), query.targets[t],
              field.target_distances[t], report);
  }
  for (int i = 0; i < 5; ++i) {
    const uint32_t v = random.Below(scene.mesh->vertex_count());
    CheckPath(scene, query, tracer->ToVertex(v), VertexPoint{v},
              field.distances[v], report);
  }
}

// The source that is named is one of the nearest.
void CheckLabels(const Scene& scene, const Query& query,
                 const DistanceField& field, Report& report) {
  const absl::StatusOr<std::vector<uint32_t>> nearest =
      NearestSources(*scene.mesh, test::Valid(*scene.mesh, query), field);
  if (!report.Check(nearest.ok(), "a traced field has labels",
                    nearest.status())) {
    return;
  }
  std::vector<std::vector<double>> single;
  for (const Source& source : query.sources) {
    single.push_back(AllDistances(
        *scene.mesh, {.sources = {source}, .algorithm = query.algorithm},
        report));
  }
  const auto holds = [&](size_t v) {
    const uint32_t label = (*nearest)[v];
    if (std::isinf(field.distances[v])) return label == kNoSource;
    return label < single.size() && !single[label].empty() &&
           AreEqual(field.distances[v], single[label][v], 4 * scene.rounding);
  };
  report.CheckAll(nearest->size(), holds, "labels name a nearest source",
                  Name(query));
}

void CheckGradients(const Scene& scene, const Query& query,
                    const DistanceField& field, Report& report) {
  const absl::StatusOr<std::vector<Point>> gradients =
      Gradients(*scene.mesh, test::Valid(*scene.mesh, query), field);
  if (!report.Check(gradients.ok(), "a traced field has gradients",
                    gradients.status())) {
    return;
  }
  const bool holds = std::ranges::all_of(*gradients, [](const Point& g) {
    const double norm = std::hypot(g[0], g[1], g[2]);
    return norm == 0 || std::abs(norm - 1) < 1e-9;
  });
  report.Check(holds, "gradients are unit vectors", Name(query));
}

void CheckLogMap(const Scene& scene, const Query& query,
                 const DistanceField& field, Report& report) {
  if (query.sources.size() != 1 || IsCurve(query.sources[0])) return;
  const absl::StatusOr<LogMap> map =
      ComputeLogMap(*scene.mesh, test::Valid(*scene.mesh, query), field);
  if (!map.ok()) {
    report.Check(absl::IsInvalidArgument(map.status()),
                 "a log map is drawn or refused", map.status(), ", ",
                 Name(query));
    return;
  }
  const auto holds = [&](size_t v) {
    const auto [x, y] = map->coordinates[v];
    if (std::isinf(field.distances[v])) return std::isnan(x);
    return AreEqual(field.distances[v] - query.sources[0].offset,
                    std::hypot(x, y), 16 * scene.rounding);
  };
  report.CheckAll(field.distances.size(), holds,
                  "the log map keeps distances from the source", Name(query));
}

void CheckIsolines(const Scene& scene, Query query, const DistanceField& field,
                   Random& random, Report& report) {
  const double level =
      test::FarthestOf(field.distances) * random.Uniform(0.05, 0.95);
  if (!(level > 0)) return;
  query.trace = false;
  query.targets.clear();
  NoCheckpoint checkpoint;
  const absl::StatusOr<std::vector<Isoline>> lines = ComputeIsolines(
      *scene.mesh, test::Valid(*scene.mesh, query), {{level}}, {}, checkpoint);
  if (!report.Check(lines.ok(), "isolines are drawn", lines.status(), ", ",
                    Name(query))) {
    return;
  }
  for (const Isoline& line : *lines) {
    query.targets.insert(query.targets.end(), line.points.begin(),
                         line.points.end());
  }
  const std::vector<double> got = AllDistances(*scene.mesh, query, report);
  const auto holds = [&](size_t i) {
    return i < field.distances.size() ||
           AreEqual(level, got[i], 8 * scene.rounding);
  };
  report.CheckAll(got.size(), holds, "isolines are at their level", level, ", ",
                  Name(query));
}

}  // namespace

void CheckQuestionLaws(const Scene& scene, Random& random, Report& report) {
  Query query{.targets = scene.points,
              .algorithm = DrawAlgorithm(scene, random),
              .trace = true};
  const uint32_t count = random.Below(3) + 1;
  for (uint32_t i = 0; i < count; ++i) {
    query.sources.push_back(
        {DrawPoint(scene, random),
         i == 0 ? 0 : scene.size() * random.Uniform(0, 0.1)});
  }
  if (random.Below(3) == 0) query.sources.push_back(DrawCurve(scene, random));
  NoCheckpoint checkpoint;
  const absl::StatusOr<DistanceField> field =
      Solve(*scene.mesh, query, {}, checkpoint);
  if (!report.Check(field.ok(), "a valid query is answered", field.status(),
                    ", ", Name(query))) {
    return;
  }
  CheckPaths(scene, query, *field, random, report);
  CheckLabels(scene, query, *field, report);
  CheckGradients(scene, query, *field, report);
  CheckLogMap(scene, query, *field, report);
  CheckIsolines(scene, query, *field, random, report);
}

}  // namespace geodesic::stress
