#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "absl/strings/str_cat.h"
#include "bench/pairs.h"
#include "bench/speed/benchmarks.h"
#include "geodesic/solve.h"
#include "tests/support/oracles/cgal_oracle.h"

namespace geodesic::speed {
namespace {

double LargestDifference(const Subject& subject,
                         const std::vector<double>& expected) {
  NoCheckpoint checkpoint;
  const std::vector<double> distances =
      Solve(*subject.mesh, {.sources = {{VertexPoint{subject.source()}}}}, {},
            checkpoint)
          .value()
          .distances;
  double largest = 0;
  for (size_t v = 0; v < distances.size(); ++v) {
    if (distances[v] == expected[v]) continue;  // 0, or infinity
    largest =
        std::max(largest, std::abs(distances[v] - expected[v]) / expected[v]);
  }
  return largest;
}

test::CgalOracle MakeCgal(const Mesh& mesh) {
  TriangleSoup soup{
      .positions = {mesh.positions().begin(), mesh.positions().end()}};
  for (uint32_t face = 0; face < mesh.face_count(); ++face) {
    soup.triangles.push_back(mesh.triangle(face));
  }
  return test::CgalOracle(soup);
}

}  // namespace

void RegisterCgal(const Subject& subject) {
  benchmark::RegisterBenchmark(
      absl::StrCat("cgal/", subject.name).c_str(),
      [subject](benchmark::State& state) {
        const test::CgalOracle cgal = MakeCgal(*subject.mesh);
        std::vector<double> distances;
        for (auto _ : state) distances = cgal.Distances(subject.source());
        state.counters["off"] = LargestDifference(subject, distances);
      })
      ->Iterations(1)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

void RegisterCgalPairs(const Subject& subject) {
  constexpr uint32_t kPairs = 3;
  benchmark::RegisterBenchmark(
      absl::StrCat("cgal_pairs/", subject.name).c_str(),
      [subject](benchmark::State& state) {
        const test::CgalOracle cgal = MakeCgal(*subject.mesh);
        const std::vector<Pair> pairs =
            RandomPairs(*subject.mesh, kPairs, kSeedOfPairs);
        PairRuns runs;
        for (auto _ : state) {
          for (const Pair& pair : pairs) {
            const double start = ProcessorSeconds();
            runs.distances.push_back(cgal.Distance(pair.from, pair.to));
            runs.seconds.push_back(ProcessorSeconds() - start);
          }
        }
        state.counters["median"] = 1e3 * Quantile(runs.seconds, 0.5);
        state.counters["off"] = LargestDifference(
            SearchPairs(*subject.mesh, pairs, nullptr, 1).value(), runs);
      })
      ->Iterations(1)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace geodesic::speed
