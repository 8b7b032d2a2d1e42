#include "bench/solve_graph_pairs.h"

#include <chrono>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "bench/measured.h"
#include "bench/pairs.h"
#include "geodesic/approximate/saddle_vertex_graph.h"
#include "geodesic/landmarks.h"

namespace geodesic {

absl::Status SolveGraphPairs(const Mesh& mesh, const QuestionOptions& question,
                             const ApproximateOptions& approximate,
                             uint32_t threads, const PairOptions& options) {
  NoCheckpoint checkpoint;
  SaddleGraphOptions graph_options = approximate.method.svg;
  graph_options.threads = threads;
  const auto start = std::chrono::steady_clock::now();
  const absl::StatusOr<std::shared_ptr<const SaddleVertexGraph>> graph =
      SaddleVertexGraph::Prepare(mesh, graph_options, checkpoint);
  if (!graph.ok()) return graph.status();
  const double prepare_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
          .count();
  const absl::StatusOr<Landmarks> landmarks =
      MakeLandmarks(mesh, options.landmarks, {}, checkpoint);
  if (!landmarks.ok()) return landmarks.status();
  const std::vector<Pair> pairs =
      options.target.has_value()
          ? std::vector<Pair>{{question.source, *options.target}}
          : RandomPairs(mesh, options.pairs, options.seed);
  for (const Pair& pair : pairs) {
    for (const uint32_t v : {pair.from, pair.to}) {
      absl::Status status = Validate(VertexPoint{v}, mesh, "pair");
      if (!status.ok()) return status;
    }
  }
  SaddleGraphSearch search(**graph);
  std::vector<double> distances, seconds, expanded;
  for (const auto& [from, to] : pairs) {
    double distance = 0;
    std::vector<double> runs;
    for (int i = 0; i < question.repeat; ++i) {
      const double before = ProcessorSeconds();
      const absl::StatusOr<double> found =
          search.Distance(from, to, &*landmarks, checkpoint);
      if (!found.ok()) return found.status();
      distance = *found;
      runs.push_back(ProcessorSeconds() - before);
    }
    distances.push_back(distance);
    seconds.push_back(Median(runs));
    expanded.push_back(static_cast<double>(search.expanded()));
  }
  nlohmann::ordered_json line{{"faces", mesh.face_count()},
                              {"vertices", mesh.vertex_count()},
                              {"algorithm", question.algorithm},
                              {"exact", false},
                              {"certified_error", nullptr},
                              {"prepare_s", prepare_seconds},
                              {"prepared_bytes", (*graph)->bytes()},
                              {"landmarks", landmarks->count()},
                              {"pairs", pairs.size()},
                              {"solve_s", Quantile(seconds, 0.5)},
                              {"solve_s_p99", Quantile(seconds, 0.99)},
                              {"expanded", Quantile(expanded, 0.5)}};
  if (options.target.has_value()) line["distance"] = distances[0];
  if (approximate.errors) {
    const absl::StatusOr<PairRuns> exact =
        SearchPairs(mesh, pairs, &*landmarks, 1);
    if (!exact.ok()) return exact.status();
    const RelativeErrors errors = CompareDistances(distances, exact->distances);
    line["mean_error"] = errors.mean;
    line["max_error"] = errors.largest;
  }
  std::cout << line.dump() << "\n";
  return absl::OkStatus();
}

}  // namespace geodesic
