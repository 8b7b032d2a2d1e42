// solve: geodesic distances of a mesh file, timed, as one line of JSON. It is
// how this project's speed, and that of the approximate methods, is compared
// with other programs'.

#include "geodesic/solve.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "bench/load_mesh.h"
#include "bench/measured.h"
#include "bench/question_options.h"
#include "bench/solve_approximate.h"
#include "bench/solve_graph_pairs.h"
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
  ApproximateOptions approximate;
};

double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
      .count();
}

absl::Status Run(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  absl::StatusOr<std::shared_ptr<const Mesh>> mesh =
      LoadMesh(options.question.mesh_file);
  if (!mesh.ok()) return mesh.status();
  const double setup_seconds = SecondsSince(start);
  if (ApproximateMethodFromName(options.question.algorithm).ok()) {
    if (options.pairs.target.has_value() || options.pairs.pairs > 0) {
      return SolveGraphPairs(**mesh, options.question, options.approximate,
                             options.threads, options.pairs);
    }
    return SolveApproximate(**mesh, setup_seconds, options.question,
                            options.approximate, options.threads,
                            options.output);
  }
  const absl::StatusOr<Algorithm> algorithm =
      AlgorithmFromName(options.question.algorithm);
  if (!algorithm.ok()) return algorithm.status();
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
    if (absl::Status status = WriteField(options.output, field.distances);
        !status.ok()) {
      return status;
    }
  }
  const SolveStatistics& statistics = field.statistics;
  std::cout << nlohmann::ordered_json{{"faces", (*mesh)->face_count()},
                                      {"vertices", (*mesh)->vertex_count()},
                                      {"algorithm", std::string(AlgorithmName(
                                                        field.algorithm))},
                                      {"exact", true},
                                      {"certified_error", 0},
                                      {"threads", options.threads},
                                      {"setup_s", setup_seconds},
                                      {"prepare_s", 0},
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
      "Solves geodesic distances on a mesh file, exactly unless --algorithm "
      "names an approximate method, and prints the cost as one line of JSON."};
  geodesic::Options options;
  geodesic::AddQuestionOptions(app, options.question,
                               geodesic::ApproximateMethodNames());
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
  geodesic::AddApproximateOptions(app, options.approximate);
  CLI11_PARSE(app, argc, argv);
  absl::Status status =
      geodesic::CheckCombination(app, options.question.algorithm);
  if (status.ok()) status = geodesic::Run(options);
  if (!status.ok()) {
    std::cerr << "solve: " << std::string(status.message()) << "\n";
    return 1;
  }
  return 0;
}
