#include <benchmark/benchmark.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "absl/strings/str_cat.h"
#include "bench/speed/benchmarks.h"
#include "bench/speed/lower_envelope.h"
#include "geodesic/solve.h"

namespace geodesic::speed {
namespace {

DistanceField SolveFrom(const Mesh& mesh, uint32_t source,
                        Algorithm algorithm) {
  NoCheckpoint checkpoint;
  return Solve(mesh,
               {.sources = {{VertexPoint{source}}}, .algorithm = algorithm}, {},
               checkpoint)
      .value();
}

void MeasureSolve(benchmark::State& state, const Subject& subject,
                  Algorithm algorithm) {
  SolveStatistics statistics;
  for (auto _ : state) {
    statistics =
        SolveFrom(*subject.mesh, subject.source(), algorithm).statistics;
  }
  state.counters["created"] = static_cast<double>(statistics.windows_created);
  state.counters["propagated"] =
      static_cast<double>(statistics.windows_propagated);
  state.counters["bytes"] = static_cast<double>(statistics.peak_solver_bytes);
}

void MeasureSources(benchmark::State& state, const Subject& subject,
                    uint32_t sources, int threads) {
  const uint32_t stride = subject.mesh->vertex_count() / sources;
  for (auto _ : state) {
    std::atomic<uint32_t> next = 0;
    std::vector<std::jthread> workers;
    workers.reserve(threads);
    for (int i = 0; i < threads; ++i) {
      workers.emplace_back([&] {
        for (uint32_t k = next++; k < sources; k = next++) {
          benchmark::DoNotOptimize(
              SolveFrom(*subject.mesh, k * stride, kDefaultAlgorithm));
        }
      });
    }
  }
}

}  // namespace

void RegisterSolve(const Subject& subject, int rounds) {
  for (const AlgorithmInfo& info : kAlgorithms) {
    if (!IsMeasured(info.algorithm)) continue;
    benchmark::RegisterBenchmark(
        absl::StrCat("solve/", std::string(info.name), "/", subject.name)
            .c_str(),
        [subject, algorithm = info.algorithm](benchmark::State& state) {
          MeasureSolve(state, subject, algorithm);
        })
        ->Iterations(1)
        ->Repetitions(rounds)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  }
}

void RegisterLowerEnvelope(const Subject& subject) {
  benchmark::RegisterBenchmark(absl::StrCat("envelope/", subject.name).c_str(),
                               [subject](benchmark::State& state) {
                                 for (auto _ : state) {
                                   state.counters["windows"] =
                                       static_cast<double>(LowerEnvelope(
                                           *subject.mesh, subject.source()));
                                 }
                               })
      ->Iterations(1)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

void RegisterSources(const Subject& subject, int sources, int most_threads,
                     int rounds) {
  for (int threads = 1; threads <= most_threads; threads *= 2) {
    benchmark::RegisterBenchmark(
        absl::StrCat("sources/", threads, "/", subject.name).c_str(),
        [subject, sources, threads](benchmark::State& state) {
          MeasureSources(state, subject, static_cast<uint32_t>(sources),
                         threads);
        })
        ->Iterations(1)
        ->Repetitions(rounds)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace geodesic::speed
