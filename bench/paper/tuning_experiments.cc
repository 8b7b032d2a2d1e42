// What the parameters of FWP do.

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/paper/experiments.h"
#include "bench/paper/table.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::paper {
namespace {

constexpr Algorithm kFwpAlgorithms[] = {Algorithm::kFwpMmp, Algorithm::kFwpCh};

// A smooth and a rough surface, and the first of the user's models.
std::vector<Subject> Subjects(const Setting& setting) {
  const uint32_t cells = setting.quick ? 25 : 140;
  std::vector<Subject> subjects = {
      Generated("sphere", test::Icosphere(setting.quick ? 3 : 5)),
      Generated("terrain", test::Terrain(cells, cells, 1, 1))};
  if (!setting.models.empty()) subjects.push_back(setting.models.front());
  return subjects;
}

void AddRow(Table& table, const Setting& setting, const Subject& subject,
            Algorithm algorithm, const std::string& policy, double value,
            const SolveOptions& options) {
  const SolveStatistics cost =
      Measure(subject, algorithm, options, setting.most_runs());
  table.Add(subject.name, subject.mesh->face_count(), AlgorithmName(algorithm),
            policy, value, cost.solve_seconds, cost.windows_created,
            cost.iterations);
}

}  // namespace

void RunBatch(const Setting& setting) {
  Table table({"mesh", "faces", "algorithm", "policy", "K or K_max", "seconds",
               "windows", "iterations"});
  const uint32_t last = setting.quick ? 1000 : 100000;
  for (const Subject& subject : Subjects(setting)) {
    for (const Algorithm algorithm : kFwpAlgorithms) {
      for (const uint32_t k : {SolveOptions().max_batch, 2000u, 20000u}) {
        AddRow(table, setting, subject, algorithm, "adaptive", k,
               {.bucket_width = 1, .max_batch = k});
      }
      // Half decades: 1, 3, 10, 32, ...
      for (double k = 1; k <= last * 1.01; k *= std::sqrt(10.0)) {
        AddRow(table, setting, subject, algorithm, "fixed", std::round(k),
               {.bucket_width = 1,
                .max_batch = static_cast<uint32_t>(std::lround(k)),
                .adaptive_batch = false});
      }
    }
  }
}

void RunBucketWidth(const Setting& setting) {
  Table table({"mesh", "faces", "algorithm", "policy", "width/l", "seconds",
               "windows", "iterations"});
  const double step = setting.quick ? 8 : 2;
  for (const Subject& subject : Subjects(setting)) {
    for (const Algorithm algorithm : kFwpAlgorithms) {
      for (double width = 1.0 / 16; width <= 512; width *= step) {
        AddRow(table, setting, subject, algorithm, "adaptive", width,
               {.bucket_width = width, .max_batch = kPaperOptions.max_batch});
      }
    }
  }
}

}  // namespace geodesic::paper
