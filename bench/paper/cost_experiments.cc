// What the algorithms cost against resolution, anisotropy and on models.

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/paper/experiments.h"
#include "bench/paper/table.h"
#include "geodesic/mesh_summary.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic::paper {
namespace {

// The algorithm of the same rule that takes windows in order of label.
Algorithm WithHeap(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::kFwpMmp:
    case Algorithm::kLcMmp:
    case Algorithm::kMmp:
      return Algorithm::kMmp;
    default:
      return Algorithm::kIch;
  }
}

class CostTable {
 public:
  explicit CostTable(const Setting& setting)
      : most_runs_(setting.most_runs()) {}

  void Add(const Subject& subject) {
    const uint64_t faces = subject.mesh->face_count();
    const double g = Summarize(*subject.mesh).anisotropy;
    std::vector<SolveStatistics> costs(kAlgorithms.size());
    for (size_t i = 0; i < kAlgorithms.size(); ++i) {
      if (!IsFeasible(kAlgorithms[i].algorithm, faces)) continue;
      costs[i] =
          Measure(subject, kAlgorithms[i].algorithm, kPaperOptions, most_runs_);
    }
    for (size_t i = 0; i < kAlgorithms.size(); ++i) {
      const SolveStatistics& cost = costs[i];
      if (cost.iterations == 0) continue;
      const Algorithm partner = WithHeap(kAlgorithms[i].algorithm);
      uint64_t partner_iterations = 0;
      for (size_t j = 0; j < kAlgorithms.size(); ++j) {
        if (kAlgorithms[j].algorithm == partner) {
          partner_iterations = costs[j].iterations;
        }
      }
      table_.Add(subject.name, faces, g, kAlgorithms[i].name,
                 cost.solve_seconds, cost.windows_created,
                 static_cast<double>(cost.windows_created) /
                     static_cast<double>(faces),
                 cost.iterations,
                 static_cast<double>(partner_iterations) /
                     static_cast<double>(cost.iterations),
                 cost.peak_wavefront);
    }
  }

 private:
  const int most_runs_;
  Table table_{"mesh",          "faces",      "g",
               "algorithm",     "seconds",    "windows",
               "windows/face",  "iterations", "heap's/these",
               "peak wavefront"};
};

}  // namespace

void RunResolution(const Setting& setting) {
  CostTable table(setting);
  for (uint32_t level = 3; level <= (setting.quick ? 4u : 6u); ++level) {
    table.Add(Generated("sphere", test::Icosphere(level)));
  }
  for (uint32_t cells = 25; cells <= (setting.quick ? 50u : 200u); cells *= 2) {
    table.Add(Generated("terrain", test::Terrain(cells, cells, 1, 1)));
  }
}

void RunAnisotropy(const Setting& setting) {
  const uint32_t vertices = setting.quick ? 1200 : 10000;
  CostTable table(setting);
  for (const double aspect : {1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0}) {
    // Around the axis it is 2.5 times as far as around the tube.
    const auto across =
        static_cast<uint32_t>(std::lround(std::sqrt(vertices / 2.5 * aspect)));
    table.Add(Generated(
        "torus", test::Torus({.around = vertices / across, .across = across})));
  }
}

void RunModels(const Setting& setting) {
  const uint32_t size = setting.quick ? 1 : 4;
  CostTable table(setting);
  table.Add(Generated("sphere", test::Icosphere(setting.quick ? 3 : 5)));
  table.Add(Generated("torus",
                      test::Torus({.around = 40 * size, .across = 16 * size})));
  table.Add(Generated(
      "noisy-torus",
      test::Torus({.around = 40 * size, .across = 16 * size, .noise = 0.02})));
  table.Add(Generated("terrain", test::Terrain(25 * size, 25 * size, 1, 1)));
  table.Add(
      Generated("plane", test::MakeGrid({.columns = 25 * size,
                                         .rows = 25 * size,
                                         .diagonals = test::Diagonals::kRandom,
                                         .jitter = 0.2})));
  for (const Subject& model : setting.models) table.Add(model);
}

}  // namespace geodesic::paper
