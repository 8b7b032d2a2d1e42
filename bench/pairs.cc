#include "bench/pairs.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <random>

#include "geodesic/computation.h"
#include "geodesic/target_search.h"

namespace geodesic {
namespace {

absl::StatusOr<ValidQuery> QueryOf(const Pair& pair, const Mesh& mesh,
                                   double tolerance = 0) {
  return ValidQuery::Make({.sources = {{VertexPoint{pair.from}}},
                           .targets = {VertexPoint{pair.to}},
                           .tolerance = tolerance},
                          mesh);
}

}  // namespace

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
    pairs.push_back({from, vertex()});
  }
  return pairs;
}

absl::StatusOr<PairRuns> SearchPairs(const Mesh& mesh,
                                     std::span<const Pair> pairs,
                                     const Landmarks* landmarks, int repeat,
                                     double tolerance) {
  TargetSearch search(mesh);
  NoCheckpoint checkpoint;
  PairRuns runs;
  for (const Pair& pair : pairs) {
    const absl::StatusOr<ValidQuery> query = QueryOf(pair, mesh, tolerance);
    if (!query.ok()) return query.status();
    std::vector<double> seconds;
    absl::StatusOr<TargetDistances> found;
    for (int i = 0; i < repeat; ++i) {
      const double start = ProcessorSeconds();
      found = search.Run(*query, landmarks, checkpoint);
      seconds.push_back(ProcessorSeconds() - start);
      if (!found.ok()) return found.status();
    }
    runs.distances.push_back(found->distances[0]);
    runs.seconds.push_back(Quantile(seconds, 0.5));
    runs.windows.push_back(
        static_cast<double>(found->statistics.windows_propagated));
  }
  return runs;
}

absl::StatusOr<PairRuns> StopAtTargets(const Mesh& mesh,
                                       std::span<const Pair> pairs) {
  NoCheckpoint checkpoint;
  PairRuns runs;
  for (const Pair& pair : pairs) {
    const absl::StatusOr<ValidQuery> query = QueryOf(pair, mesh);
    if (!query.ok()) return query.status();
    const double start = ProcessorSeconds();
    absl::StatusOr<std::unique_ptr<Computation>> computation =
        StartComputation(mesh, *query, {});
    if (!computation.ok()) return computation.status();
    absl::Status status = (*computation)->Advance({.targets = 1}, checkpoint);
    if (!status.ok()) return status;
    runs.seconds.push_back(ProcessorSeconds() - start);
    const DistanceField field = (*computation)->Field();
    runs.distances.push_back(field.target_distances[0]);
    runs.windows.push_back(
        static_cast<double>(field.statistics.windows_propagated));
  }
  return runs;
}

double LargestDifference(const PairRuns& a, const PairRuns& b) {
  double largest = 0;
  for (size_t i = 0; i < std::min(a.distances.size(), b.distances.size());
       ++i) {
    if (a.distances[i] == b.distances[i]) continue;  // 0, or infinity
    largest = std::max(
        largest, std::abs(a.distances[i] - b.distances[i]) / b.distances[i]);
  }
  return largest;
}

double ProcessorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec);
}

double Quantile(std::vector<double> values, double part) {
  std::ranges::sort(values);
  return values[static_cast<size_t>(
      std::lround(part * static_cast<double>(values.size() - 1)))];
}

}  // namespace geodesic
