#include "bench/solve_pairs.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "bench/measured.h"
#include "bench/pairs.h"
#include "geodesic/landmarks.h"

namespace geodesic {
namespace {

nlohmann::ordered_json Summary(const PairRuns& runs) {
  return {{"solve_s", Quantile(runs.seconds, 0.5)},
          {"solve_s_p99", Quantile(runs.seconds, 0.99)},
          {"windows_propagated", Quantile(runs.windows, 0.5)},
          {"windows_propagated_p99", Quantile(runs.windows, 0.99)}};
}

}  // namespace

void AddPairOptions(CLI::App& app, PairOptions& options) {
  app.add_option("--target", options.target,
                 "search the distance to this vertex instead of the field");
  app.add_option("--pairs", options.pairs,
                 "search the distances of so many random pairs of vertices");
  app.add_option("--landmarks", options.landmarks,
                 "landmarks made before the search")
      ->check(CLI::Range(0u, Landmarks::kMost))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "of the random pairs")
      ->capture_default_str();
  app.add_option("--compare", options.compare,
                 "also compute so many of the pairs as fields that stop at the "
                 "target")
      ->capture_default_str();
}

absl::Status SolvePairs(const Mesh& mesh, const QuestionOptions& question,
                        const PairOptions& options) {
  NoCheckpoint checkpoint;
  const double start = ProcessorSeconds();
  Landmarks landmarks(mesh);
  if (options.landmarks > 0) {
    absl::StatusOr<Landmarks> made =
        MakeLandmarks(mesh, options.landmarks, {}, checkpoint);
    if (!made.ok()) return made.status();
    landmarks = *std::move(made);
  }
  const double landmarks_seconds = ProcessorSeconds() - start;
  std::vector<Pair> pairs =
      options.target.has_value()
          ? std::vector<Pair>{{question.source, *options.target}}
          : RandomPairs(mesh, options.pairs, options.seed);
  const absl::StatusOr<PairRuns> found =
      SearchPairs(mesh, pairs, &landmarks, question.repeat, options.tolerance);
  if (!found.ok()) return found.status();
  nlohmann::ordered_json line{
      {"faces", mesh.face_count()},     {"vertices", mesh.vertex_count()},
      {"landmarks", landmarks.count()}, {"landmarks_s", landmarks_seconds},
      {"tolerance", options.tolerance}, {"pairs", pairs.size()}};
  if (options.target.has_value()) line["distance"] = found->distances[0];
  line.update(Summary(*found));
  if (options.errors) {
    const absl::StatusOr<PairRuns> exact =
        SearchPairs(mesh, pairs, &landmarks, 1);
    if (!exact.ok()) return exact.status();
    const RelativeErrors errors =
        CompareDistances(found->distances, exact->distances);
    line["mean_error"] = errors.mean;
    line["max_error"] = errors.largest;
  }
  pairs.resize(std::min<size_t>(pairs.size(), options.compare));
  if (!pairs.empty()) {
    const absl::StatusOr<PairRuns> stopped = StopAtTargets(mesh, pairs);
    if (!stopped.ok()) return stopped.status();
    size_t same = 0;
    for (size_t i = 0; i < pairs.size(); ++i) {
      same += found->distances[i] == stopped->distances[i];
    }
    line["stop_at_target"] = Summary(*stopped);
    line["largest_difference"] = LargestDifference(*found, *stopped);
    line["same_bits"] = same;
  }
  std::cout << line.dump() << "\n";
  return absl::OkStatus();
}

}  // namespace geodesic
