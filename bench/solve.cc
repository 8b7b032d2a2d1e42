// solve: exact geodesic distances of a mesh file, timed, as one line of JSON.
// It is how this project's speed is compared with other programs'.

#include "geodesic/solve.h"

#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "bench/load_mesh.h"
#include "bench/question_options.h"
#include "bench/solve_pairs.h"
#include "geodesic/mesh.h"

namespace geodesic {
namespace {

struct Options {
  QuestionOptions question;
  uint32_t threads = SolveOptions().threads;
  double bucket_width = SolveOptions().bucket_width;
  uint32_t max_batch = SolveOptions().max_batch;
  bool fixed_batch = false;
  std::string output;
  PairOptions pairs;
};

double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
      .count();
}

absl::Status Write(const std::string& path, const std::vector<double>& values) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(values.data()),
             static_cast<std::streamsize>(values.size() * sizeof(double)));
  if (!file.flush()) return absl::UnavailableError("cannot write " + path);
  return absl::OkStatus();
}

double Median(std::vector<double> values) {
  const auto middle =
      values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double PeakRssMb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

absl::Status Run(const Options& options) {
  absl::StatusOr<Algorithm> algorithm =
      AlgorithmFromName(options.question.algorithm);
  if (!algorithm.ok()) return algorithm.status();

  const auto start = std::chrono::steady_clock::now();
  absl::StatusOr<std::shared_ptr<const Mesh>> mesh =
      LoadMesh(options.question.mesh_file);
  if (!mesh.ok()) return mesh.status();
  const double setup_seconds = SecondsSince(start);
  if (options.pairs.target.has_value() || options.pairs.pairs > 0) {
    return SolvePairs(**mesh, options.question, options.pairs);
  }

  const Query query{.sources = {{VertexPoint{options.question.source}}},
                    .algorithm = *algorithm};
  NoCheckpoint checkpoint;
  std::vector<double> seconds;
  DistanceField field;
  for (int i = 0; i < options.question.repeat; ++i) {
    absl::StatusOr<DistanceField> solved =
        Solve(**mesh, query,
              {.bucket_width = options.bucket_width,
               .max_batch = options.max_batch,
               .adaptive_batch = !options.fixed_batch,
               .threads = options.threads},
              checkpoint);
    if (!solved.ok()) return solved.status();
    field = *std::move(solved);
    seconds.push_back(field.statistics.solve_seconds);
  }
  if (!options.output.empty()) {
    if (absl::Status status = Write(options.output, field.distances);
        !status.ok()) {
      return status;
    }
  }
  const SolveStatistics& statistics = field.statistics;
  std::cout << nlohmann::ordered_json{{"faces", (*mesh)->face_count()},
                                      {"vertices", (*mesh)->vertex_count()},
                                      {"algorithm", std::string(AlgorithmName(
                                                        field.algorithm))},
                                      {"threads", options.threads},
                                      {"setup_s", setup_seconds},
                                      {"solve_s", Median(seconds)},
                                      {"solve_s_all", seconds},
                                      {"windows_created",
                                       statistics.windows_created},
                                      {"windows_propagated",
                                       statistics.windows_propagated},
                                      {"iterations", statistics.iterations},
                                      {"peak_windows", statistics.peak_windows},
                                      {"peak_rss_mb", PeakRssMb()}}
                   .dump()
            << "\n";
  return absl::OkStatus();
}

}  // namespace
}  // namespace geodesic

int main(int argc, char** argv) {
  CLI::App app{
      "Solves exact geodesic distances on a mesh file and prints the cost as "
      "one line of JSON."};
  geodesic::Options options;
  geodesic::AddQuestionOptions(app, options.question);
  app.add_option("--threads", options.threads,
                 "threads to solve with; the result is the same to the bit")
      ->check(CLI::Range(1u, geodesic::kMostSolveThreads))
      ->capture_default_str();
  app.add_option("--bucket-width", options.bucket_width,
                 "FWP bucket width in units of h / sqrt(n)")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--max-batch", options.max_batch,
                 "most windows an FWP iteration takes (the paper's K_max)")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--fixed-batch", options.fixed_batch,
               "every FWP iteration takes --max-batch windows; with 1, buckets "
               "are drained one by one");
  app.add_option("--output", options.output,
                 "write the field to this file, raw little-endian doubles");
  geodesic::AddPairOptions(app, options.pairs);
  CLI11_PARSE(app, argc, argv);
  if (absl::Status status = geodesic::Run(options); !status.ok()) {
    std::cerr << "solve: " << std::string(status.message()) << "\n";
    return 1;
  }
  return 0;
}
