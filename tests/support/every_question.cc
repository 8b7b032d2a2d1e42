#include "tests/support/every_question.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "absl/status/statusor.h"
#include "geodesic/approximate/prepare.h"
#include "geodesic/field_quantities.h"
#include "geodesic/isolines.h"
#include "geodesic/landmarks.h"
#include "geodesic/log_map.h"
#include "geodesic/path.h"
#include "geodesic/rows/kept_searches.h"
#include "geodesic/rows/matrix.h"
#include "geodesic/rows/pairs.h"
#include "geodesic/sampling.h"
#include "geodesic/solve.h"
#include "geodesic/target_search.h"
#include "geodesic/trace.h"
#include "geodesic_types/algorithms.h"
#include "tests/support/queries.h"
#include "tests/support/random.h"

namespace geodesic::test {
namespace {

Query From(uint32_t source, bool trace) {
  return {.sources = {{VertexPoint{source}}}, .trace = trace};
}

// A question about a field with its trace.
template <typename Ask>
AnyQuestion OfField(std::string name, Ask ask) {
  return {std::move(name),
          [ask](const Mesh& mesh, uint32_t source, Checkpoint& checkpoint) {
            const ValidQuery query = Valid(mesh, From(source, /*trace=*/true));
            const DistanceField field =
                Solve(mesh, From(source, /*trace=*/true)).value();
            absl::Status status = checkpoint.Poll({});
            if (!status.ok()) return status;
            return ask(mesh, query, field, checkpoint);
          }};
}

absl::Status TraceSome(const Mesh& mesh, const ValidQuery& query,
                       const DistanceField& field, Checkpoint& checkpoint) {
  constexpr uint32_t kPaths = 8;
  const PathTracer tracer = PathTracer::Create(mesh, query, field).value();
  const uint32_t count = mesh.vertex_count();
  for (uint32_t i = 1; i <= std::min(kPaths, count); ++i) {
    const uint32_t v = count - 1 - (count - 1) / kPaths * (i - 1);
    absl::Status status = tracer.ToVertex(v, checkpoint).status();
    if (!status.ok()) return status;
  }
  return absl::OkStatus();
}

absl::Status Search(const Mesh& mesh, uint32_t source, Checkpoint& checkpoint) {
  Query query = From(source, /*trace=*/true);
  query.targets = {VertexPoint{mesh.vertex_count() - 1}};
  TargetSearch search(mesh);
  return search.Run(Valid(mesh, query), nullptr, checkpoint).status();
}

// Once around a large part of the mesh.
absl::Status FollowLine(const Mesh& mesh, uint32_t source,
                        Checkpoint& checkpoint) {
  const double size = std::ldexp(1.0, mesh.scale_exponent());
  const absl::StatusOr<LineTracer> tracer =
      LineTracer::From(mesh, VertexPoint{source});
  if (!tracer.ok()) return tracer.status();
  return tracer->Trace(0.0, 100 * size, checkpoint).status();
}

// All rows, of which the first is a search and the second a field.
absl::Status AskPairs(const Mesh& mesh, uint32_t source,
                      Checkpoint& checkpoint) {
  const VertexPoint last{mesh.vertex_count() - 1};
  std::vector<PointPair> pairs = {{VertexPoint{source}, last}};
  for (uint32_t v = 0; v < kFieldInSearches; ++v) {
    pairs.push_back({VertexPoint{source + 1}, VertexPoint{v}});
  }
  KeptSearches searches(mesh);
  const auto question = PairQuestion::Make(mesh, pairs, {}, searches, 1);
  if (!question.ok()) return question.status();
  for (uint64_t row = 0; row < (*question)->rows().size(); ++row) {
    absl::Status status = (*question)->Answer(row, checkpoint).status();
    if (!status.ok()) return status;
  }
  return absl::OkStatus();
}

absl::Status AskMatrix(const Mesh& mesh, uint32_t source,
                       Checkpoint& checkpoint) {
  KeptSearches searches(mesh);
  const auto question = MatrixQuestion::Make(
      mesh, Valid(mesh, From(source, /*trace=*/false)), {}, {}, searches);
  return question->Answer(0, checkpoint).status();
}

absl::Status Approximate(const Mesh& mesh, uint32_t source,
                         const MethodChoice& choice, Checkpoint& checkpoint) {
  auto method = PrepareMethod(mesh, choice, 1, checkpoint);
  if (!method.ok()) return method.status();
  return (*method)
      ->Distances(Valid(mesh, From(source, /*trace=*/false)), checkpoint)
      .status();
}

enum class Where { kInFaces, kOnEdges, kAtVertices };

std::vector<Source> ManySources(const Mesh& mesh, Where where, uint32_t count) {
  Random random(1);
  std::vector<Source> sources;
  while (sources.size() < count) {
    const uint32_t face = random.Below(mesh.face_count());
    const Triangle& corners = mesh.triangle(face);
    const uint32_t side = random.Below(3);
    const double a = random.Uniform(0.01, 0.98);
    const double b = random.Uniform(0.01, 0.99 - a);
    switch (where) {
      case Where::kInFaces:
        sources.push_back({FacePoint{face, {a, b, 1 - a - b}}});
        break;
      case Where::kOnEdges:
        sources.push_back(
            {EdgePoint{corners[side], corners[(side + 1) % 3], a}});
        break;
      case Where::kAtVertices:
        sources.push_back({VertexPoint{corners[side]}, a});
    }
  }
  return sources;
}

}  // namespace

std::vector<AnyQuestion> EveryQuestion(bool algorithms) {
  std::vector<AnyQuestion> all;
  for (const AlgorithmInfo& info : kAlgorithms) {
    const Algorithm algorithm = info.algorithm;
    if (!algorithms && algorithm != kDefaultAlgorithm) continue;
    all.push_back({"field by " + std::string(AlgorithmName(algorithm)),
                   [algorithm](const Mesh& mesh, uint32_t source,
                               Checkpoint& checkpoint) {
                     Query query = From(source, /*trace=*/true);
                     query.algorithm = algorithm;
                     return Solve(mesh, query, {}, checkpoint).status();
                   }});
  }
  all.push_back(OfField("paths", TraceSome));
  all.push_back(OfField("log map", [](const auto& mesh, const auto& query,
                                      const auto& field, auto& checkpoint) {
    constexpr double kNoLimit = std::numeric_limits<double>::infinity();
    return ComputeLogMap(mesh, query, field, kNoLimit, checkpoint).status();
  }));
  all.push_back(OfField("gradients", [](const auto& mesh, const auto& query,
                                        const auto& field, auto& checkpoint) {
    return Gradients(mesh, query, field, checkpoint).status();
  }));
  all.push_back(
      OfField("nearest sources", [](const auto& mesh, const auto& query,
                                    const auto& field, auto& checkpoint) {
        return NearestSources(mesh, query, field, checkpoint).status();
      }));
  all.push_back({"search", Search});
  all.push_back({"trace", FollowLine});
  all.push_back({"pairs", AskPairs});
  all.push_back({"matrix", AskMatrix});
  all.push_back({"isolines",
                 [](const Mesh& mesh, uint32_t source, Checkpoint& checkpoint) {
                   IsolineOptions isolines;
                   for (int i = 1; i < 20; ++i) {
                     isolines.levels.push_back(0.1 * i);
                   }
                   return ComputeIsolines(mesh,
                                          Valid(mesh, From(source, false)),
                                          isolines, {}, checkpoint)
                       .status();
                 }});
  all.push_back({"samples",
                 [](const Mesh& mesh, uint32_t source, Checkpoint& checkpoint) {
                   return SampleFarthestPoints(mesh,
                                               Valid(mesh, From(source, false)),
                                               4, {}, checkpoint)
                       .status();
                 }});
  all.push_back(
      {"landmarks", [](const Mesh& mesh, uint32_t, Checkpoint& checkpoint) {
         return MakeLandmarks(mesh, 2, {}, checkpoint).status();
       }});
  for (const ApproximateMethodInfo& info : kApproximateMethods) {
    all.push_back({std::string(info.name),
                   [method = info.method](const Mesh& mesh, uint32_t source,
                                          Checkpoint& checkpoint) {
                     return Approximate(mesh, source, {.method = method},
                                        checkpoint);
                   }});
  }
  return all;
}

std::vector<AnyQuestion> QuestionsOfManySources(uint32_t sources,
                                                bool algorithms) {
  const std::pair<const char*, Where> places[] = {
      {"sources in faces", Where::kInFaces},
      {"sources on edges", Where::kOnEdges},
      {"sources with offsets", Where::kAtVertices}};
  std::vector<AnyQuestion> all;
  for (const auto& [name, where] : places) {
    for (const AlgorithmInfo& info : kAlgorithms) {
      const Algorithm algorithm = info.algorithm;
      if (!algorithms && algorithm != kDefaultAlgorithm) continue;
      const auto query = [=, where = where](const Mesh& mesh) {
        return Query{.sources = ManySources(mesh, where, sources),
                     .algorithm = algorithm};
      };
      const std::string what =
          std::string(name) + " by " + std::string(AlgorithmName(algorithm));
      all.push_back({"field of " + what,
                     [=](const Mesh& mesh, uint32_t, Checkpoint& checkpoint) {
                       return Solve(mesh, query(mesh), {}, checkpoint).status();
                     }});
      all.push_back({"isolines of " + what,
                     [=](const Mesh& mesh, uint32_t, Checkpoint& checkpoint) {
                       const IsolineOptions isolines{.levels = {0.01, 0.1, 0.5},
                                                     .chord_error = 1e-6};
                       return ComputeIsolines(mesh, Valid(mesh, query(mesh)),
                                              isolines, {}, checkpoint)
                           .status();
                     }});
    }
  }
  return all;
}

}  // namespace geodesic::test
