#include "bench/solve_pairs.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/computation.h"
#include "geodesic/landmarks.h"
#include "geodesic/target_search.h"

namespace geodesic {
namespace {

using Clock = std::chrono::steady_clock;
using Pair = std::pair<uint32_t, uint32_t>;

double SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// What some pairs took, in their order.
struct Runs {
  std::vector<double> distances, seconds, windows;
};

double Quantile(std::vector<double> values, double part) {
  std::ranges::sort(values);
  return values[static_cast<size_t>(
      part * static_cast<double>(values.size() - 1) + 0.5)];
}

nlohmann::ordered_json Summary(const Runs& runs) {
  return {{"solve_s", Quantile(runs.seconds, 0.5)},
          {"solve_s_p99", Quantile(runs.seconds, 0.99)},
          {"windows_propagated", Quantile(runs.windows, 0.5)},
          {"windows_propagated_p99", Quantile(runs.windows, 0.99)}};
}

// Between vertices that have faces.
std::vector<Pair> RandomPairs(const Mesh& mesh, uint32_t count, uint32_t seed) {
  std::mt19937 random(seed);
  const auto vertex = [&] {
    for (;;) {
      const auto v = static_cast<uint32_t>(random() % mesh.vertex_count());
      if (!mesh.Outgoing(v).empty()) return v;
    }
  };
  std::vector<Pair> pairs;
  while (pairs.size() < count) {
    const uint32_t from = vertex();
    pairs.emplace_back(from, vertex());
  }
  return pairs;
}

absl::StatusOr<ValidQuery> QueryOf(const Pair& pair, const Mesh& mesh) {
  return ValidQuery::Make({.sources = {{VertexPoint{pair.first}}},
                           .targets = {VertexPoint{pair.second}}},
                          mesh);
}

absl::StatusOr<Runs> Search(const Mesh& mesh, const std::vector<Pair>& pairs,
                            const Landmarks& landmarks, int repeat) {
  TargetSearch search(mesh);
  NoCheckpoint checkpoint;
  Runs runs;
  for (const Pair& pair : pairs) {
    const absl::StatusOr<ValidQuery> query = QueryOf(pair, mesh);
    if (!query.ok()) return query.status();
    std::vector<double> seconds;
    absl::StatusOr<TargetDistances> found;
    for (int i = 0; i < repeat; ++i) {
      const Clock::time_point start = Clock::now();
      found = search.Run(*query, &landmarks, checkpoint);
      seconds.push_back(SecondsSince(start));
      if (!found.ok()) return found.status();
    }
    runs.distances.push_back(found->distances[0]);
    runs.seconds.push_back(Quantile(seconds, 0.5));
    runs.windows.push_back(
        static_cast<double>(found->statistics.windows_propagated));
  }
  return runs;
}

// As a field that stops at the target.
absl::StatusOr<Runs> StopAtTargets(const Mesh& mesh,
                                   std::span<const Pair> pairs) {
  NoCheckpoint checkpoint;
  Runs runs;
  for (const Pair& pair : pairs) {
    const absl::StatusOr<ValidQuery> query = QueryOf(pair, mesh);
    if (!query.ok()) return query.status();
    const Clock::time_point start = Clock::now();
    absl::StatusOr<std::unique_ptr<Computation>> computation =
        StartComputation(mesh, *query, {});
    if (!computation.ok()) return computation.status();
    absl::Status status = (*computation)->Advance({.targets = 1}, checkpoint);
    if (!status.ok()) return status;
    runs.seconds.push_back(SecondsSince(start));
    const DistanceField field = (*computation)->Field();
    runs.distances.push_back(field.target_distances[0]);
    runs.windows.push_back(
        static_cast<double>(field.statistics.windows_propagated));
  }
  return runs;
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
  const Clock::time_point start = Clock::now();
  Landmarks landmarks(mesh);
  if (options.landmarks > 0) {
    absl::StatusOr<Landmarks> made =
        MakeLandmarks(mesh, options.landmarks, {}, checkpoint);
    if (!made.ok()) return made.status();
    landmarks = *std::move(made);
  }
  const double landmarks_seconds = SecondsSince(start);
  std::vector<Pair> pairs =
      options.target.has_value()
          ? std::vector<Pair>{{question.source, *options.target}}
          : RandomPairs(mesh, options.pairs, options.seed);
  const absl::StatusOr<Runs> found =
      Search(mesh, pairs, landmarks, question.repeat);
  if (!found.ok()) return found.status();
  nlohmann::ordered_json line{{"faces", mesh.face_count()},
                              {"vertices", mesh.vertex_count()},
                              {"landmarks", landmarks.count()},
                              {"landmarks_s", landmarks_seconds},
                              {"pairs", pairs.size()}};
  if (options.target.has_value()) line["distance"] = found->distances[0];
  line.update(Summary(*found));
  pairs.resize(std::min<size_t>(pairs.size(), options.compare));
  if (!pairs.empty()) {
    const absl::StatusOr<Runs> stopped = StopAtTargets(mesh, pairs);
    if (!stopped.ok()) return stopped.status();
    double error = 0;
    size_t same = 0;
    for (size_t i = 0; i < pairs.size(); ++i) {
      const double a = found->distances[i], b = stopped->distances[i];
      same += a == b;
      if (a != b) error = std::max(error, std::abs(a - b) / b);
    }
    line["stop_at_target"] = Summary(*stopped);
    line["largest_difference"] = error;
    line["same_bits"] = same;
  }
  std::cout << line.dump() << "\n";
  return absl::OkStatus();
}

}  // namespace geodesic
