#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "bench/pairs.h"
#include "bench/speed/benchmarks.h"
#include "geodesic/landmarks.h"

namespace geodesic::speed {
namespace {

// The ways to find a pair take turns after so many.
constexpr size_t kTurn = 50;

absl::Status Append(const absl::StatusOr<PairRuns>& some, PairRuns& all) {
  if (!some.ok()) return some.status();
  const auto append = [](const std::vector<double>& from,
                         std::vector<double>& to) {
    to.insert(to.end(), from.begin(), from.end());
  };
  append(some->distances, all.distances);
  append(some->seconds, all.seconds);
  append(some->windows, all.windows);
  return absl::OkStatus();
}

void Count(const std::string& way, const PairRuns& runs,
           benchmark::State& state) {
  state.counters[way] = 1e3 * Quantile(runs.seconds, 0.5);
  state.counters[way + "_p99"] = 1e3 * Quantile(runs.seconds, 0.99);
  state.counters[way + "_windows"] = Quantile(runs.windows, 0.5);
  state.counters[way + "_windows_p99"] = Quantile(runs.windows, 0.99);
}

absl::Status MeasurePairs(const Mesh& mesh, uint32_t count,
                          benchmark::State& state) {
  NoCheckpoint checkpoint;
  const double start = ProcessorSeconds();
  const absl::StatusOr<Landmarks> landmarks =
      MakeLandmarks(mesh, Landmarks::kMost, {}, checkpoint);
  if (!landmarks.ok()) return landmarks.status();
  state.counters["made"] = 1e3 * (ProcessorSeconds() - start);
  const std::vector<Pair> pairs = RandomPairs(mesh, count, kSeedOfPairs);
  PairRuns search, directed, field;
  absl::Status status;
  for (size_t i = 0; i < pairs.size(); i += kTurn) {
    const std::span<const Pair> turn =
        std::span(pairs).subspan(i, std::min(kTurn, pairs.size() - i));
    status.Update(Append(SearchPairs(mesh, turn, nullptr, 1), search));
    status.Update(Append(SearchPairs(mesh, turn, &*landmarks, 1), directed));
    status.Update(Append(StopAtTargets(mesh, turn), field));
    if (!status.ok()) return status;
  }
  Count("search", search, state);
  Count("landmarks", directed, state);
  Count("field", field, state);
  state.counters["off"] = std::max(LargestDifference(search, field),
                                   LargestDifference(directed, field));
  return absl::OkStatus();
}

}  // namespace

void RegisterPairs(const Subject& subject, uint32_t count) {
  benchmark::RegisterBenchmark(
      absl::StrCat("pairs/", subject.name).c_str(),
      [subject, count](benchmark::State& state) {
        absl::Status status;
        for (auto _ : state) {
          status = MeasurePairs(*subject.mesh, count, state);
        }
        if (!status.ok()) {
          state.SkipWithError(std::string(status.message()).c_str());
        }
      })
      ->Iterations(1)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace geodesic::speed
