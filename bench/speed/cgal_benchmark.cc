#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "absl/strings/str_cat.h"
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

}  // namespace

void RegisterCgal(const Subject& subject) {
  benchmark::RegisterBenchmark(
      absl::StrCat("cgal/", subject.name).c_str(),
      [subject](benchmark::State& state) {
        const Mesh& mesh = *subject.mesh;
        TriangleSoup soup{
            .positions = {mesh.positions().begin(), mesh.positions().end()}};
        for (uint32_t face = 0; face < mesh.face_count(); ++face) {
          soup.triangles.push_back(mesh.triangle(face));
        }
        const test::CgalOracle cgal(soup);
        std::vector<double> distances;
        for (auto _ : state) distances = cgal.Distances(subject.source());
        state.counters["off"] = LargestDifference(subject, distances);
      })
      ->Iterations(1)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace geodesic::speed
