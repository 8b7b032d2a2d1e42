#include "bench/paper/measurement.h"

#include <ctime>
#include <filesystem>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "bench/load_mesh.h"
#include "geodesic/solve.h"

namespace geodesic::paper {

Subject Generated(std::string name, TriangleSoup soup) {
  return {std::move(name), Mesh::Build(std::move(soup)).value()};
}

absl::StatusOr<std::vector<Subject>> LoadSubjects(
    std::span<const std::string> files) {
  std::vector<Subject> subjects;
  for (const std::string& file : files) {
    absl::StatusOr<std::shared_ptr<const Mesh>> mesh = LoadMesh(file);
    if (!mesh.ok()) {
      return absl::Status(mesh.status().code(),
                          absl::StrCat(file, ": ", mesh.status().message()));
    }
    subjects.push_back(
        {std::filesystem::path(file).stem().string(), *std::move(mesh)});
  }
  return subjects;
}

SolveStatistics Measure(const Subject& subject, Algorithm algorithm,
                        const SolveOptions& options, int most_runs) {
  constexpr double kEnoughSeconds = 0.3;
  const Query query{.sources = {{VertexPoint{subject.source()}}},
                    .algorithm = algorithm};
  NoCheckpoint checkpoint;
  SolveStatistics fastest;
  double spent = 0;
  for (int run = 0; run < most_runs && spent < kEnoughSeconds; ++run) {
    const std::clock_t start = std::clock();
    SolveStatistics statistics =
        Solve(*subject.mesh, query, options, checkpoint).value().statistics;
    statistics.solve_seconds =
        static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    spent += statistics.solve_seconds;
    if (run == 0 || statistics.solve_seconds < fastest.solve_seconds) {
      fastest = statistics;
    }
  }
  return fastest;
}

}  // namespace geodesic::paper
