// solve: geodesic distances of a mesh file, timed, as one line of JSON. It is
// how this project's speed, and that of the approximate methods, is compared
// with other programs'.

#include "geodesic/solve.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "bench/measured.h"
#include "bench/question_options.h"
#include "bench/solve_approximate.h"
#include "bench/solve_graph_pairs.h"
#include "bench/solve_pairs.h"
#include "geodesic/mesh.h"
#include "geodesic/mesh_file.h"
#include "geodesic/parallel_chen_han.h"

namespace geodesic {
namespace {

struct Options {
  QuestionOptions question;
  uint32_t threads = SolveOptions().threads;
  double bucket_width = SolveOptions().bucket_width;
  uint32_t max_batch = SolveOptions().max_batch;
  bool fixed_batch = false;
  double tolerance = 0;
  std::string output;
  PairOptions pairs;
  ApproximateOptions approximate;
};

// Apart from the algorithms of the list (parallel_chen_han.h).
constexpr char kByLevels[] = "pch";

absl::StatusOr<DistanceField> SolveField(const Mesh& mesh,
                                         const Options& options) {
  const bool is_by_levels = options.question.algorithm == kByLevels;
  const absl::StatusOr<Algorithm> algorithm =
      is_by_levels ? kDefaultAlgorithm
                   : AlgorithmFromName(options.question.algorithm);
  if (!algorithm.ok()) return algorithm.status();
  const absl::StatusOr<ValidQuery> query =
      ValidQuery::Make({.sources = {{VertexPoint{options.question.source}}},
                        .algorithm = *algorithm,
                        .tolerance = options.tolerance},
                       mesh);
  if (!query.ok()) return query.status();
  NoCheckpoint checkpoint;
  if (is_by_levels) {
    return SolveByLevels(mesh, *query, {.threads = options.threads},
                         checkpoint);
  }
  return Solve(mesh, *query,
               {.bucket_width = options.bucket_width,
                .max_batch = options.max_batch,
                .adaptive_batch = !options.fixed_batch,
                .threads = options.threads},
               checkpoint);
}

double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
      .count();
}

// Beside the exact field: the errors, and at how many vertices one exceeds what
// is certified there.
absl::Status AddErrors(const Mesh& mesh, Options options,
                       const DistanceField& field,
                       nlohmann::ordered_json& line) {
  options.tolerance = 0;
  const absl::StatusOr<DistanceField> exact = SolveField(mesh, options);
  if (!exact.ok()) return exact.status();
  const RelativeErrors errors =
      CompareDistances(field.distances, exact->distances);
  line["mean_error"] = errors.mean;
  line["max_error"] = errors.largest;
  uint32_t beyond = 0;
  for (size_t v = 0; v < field.certified_errors.size(); ++v) {
    const double distance = exact->distances[v];
    if (std::isinf(distance) && std::isinf(field.distances[v])) continue;
    beyond += !(std::abs(field.distances[v] - distance) <=
                field.certified_errors[v] * distance);
  }
  line["beyond_bound"] = beyond;
  return absl::OkStatus();
}

absl::Status Run(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  absl::StatusOr<std::shared_ptr<const Mesh>> mesh =
      ReadMeshFile(options.question.mesh_file);
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
  const bool is_by_levels = options.question.algorithm == kByLevels;
  if (options.pairs.target.has_value() || options.pairs.pairs > 0) {
    if (is_by_levels) {
      return absl::InvalidArgumentError("pch computes fields, no pairs");
    }
    PairOptions pairs = options.pairs;
    pairs.tolerance = options.tolerance;
    pairs.errors = options.approximate.errors;
    return SolvePairs(**mesh, options.question, pairs);
  }
  std::vector<double> seconds;
  DistanceField field;
  for (int i = 0; i < options.question.repeat; ++i) {
    absl::StatusOr<DistanceField> solved = SolveField(**mesh, options);
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
  nlohmann::ordered_json line{
      {"faces", (*mesh)->face_count()},
      {"vertices", (*mesh)->vertex_count()},
      {"algorithm",
       is_by_levels ? kByLevels : std::string(AlgorithmName(field.algorithm))},
      {"tolerance", options.tolerance},
      {"exact", field.certified_error == 0},
      {"certified_error", field.certified_error},
      {"threads", options.threads},
      {"setup_s", setup_seconds},
      {"prepare_s", 0},
      {"solve_s", Median(seconds)},
      {"solve_s_all", seconds},
      {"windows_created", statistics.windows_created},
      {"windows_propagated", statistics.windows_propagated},
      {"iterations", statistics.iterations},
      {"peak_windows", statistics.peak_windows},
      {"peak_rss_mb", PeakRssMb()}};
  if (options.approximate.errors) {
    absl::Status status = AddErrors(**mesh, options, field, line);
    if (!status.ok()) return status;
  }
  std::cout << line.dump() << "\n";
  return absl::OkStatus();
}

}  // namespace
}  // namespace geodesic

int main(int argc, char** argv) {
  CLI::App app{
      "Solves geodesic distances on a mesh file, exactly unless --tolerance is "
      "given or --algorithm names an approximate method, and prints the cost "
      "as one line of JSON."};
  geodesic::Options options;
  std::vector<std::string> others = geodesic::ApproximateMethodNames();
  others.emplace_back(geodesic::kByLevels);
  geodesic::AddQuestionOptions(app, options.question, std::move(others));
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
  app.add_option("--tolerance", options.tolerance,
                 "the largest relative error, certified; 0 for none")
      ->capture_default_str();
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
