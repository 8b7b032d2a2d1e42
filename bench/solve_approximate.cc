#include "bench/solve_approximate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "bench/measured.h"
#include "geodesic/solve.h"

namespace geodesic {
namespace {

// Who takes an option.
struct OptionTakers {
  const char* option;
  bool exact;
  std::vector<ApproximateMethod> methods;
};

std::vector<OptionTakers> AllTakers(const CLI::App& app) {
  using enum ApproximateMethod;
  return {{"--threads", true, {kSvg, kGtu}},
          {"--bucket-width", true, {}},
          {"--max-batch", true, {}},
          {"--fixed-batch", true, {}},
          {"--tolerance", true, {}},
          {"--target", true, {kSvg}},
          {"--pairs", true, {kSvg}},
          {"--landmarks", true, {kSvg}},
          {"--seed", true, {kSvg}},
          {"--compare", true, {}},
          {"--lambda", false, {kHeat}},
          {"--no-intrinsic-delaunay", false, {kHeat}},
          {"--neighbours", false, {kSvg}},
          {"--build-with", false, {kSvg}},
          {"--samples", false, {kGtu}},
          {"--errors",
           app.count("--tolerance") > 0,
           {kFmm, kFmmUntidy, kHeat, kSvg, kGtu}}};
}

}  // namespace

std::vector<std::string> ApproximateMethodNames() {
  std::vector<std::string> names;
  names.reserve(kApproximateMethods.size());
  for (const ApproximateMethodInfo& info : kApproximateMethods) {
    names.emplace_back(info.name);
  }
  return names;
}

void AddApproximateOptions(CLI::App& app, ApproximateOptions& options) {
  app.add_option("--lambda", options.method.heat.lambda,
                 "heat: it spreads for lambda h^2")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("!--no-intrinsic-delaunay",
               options.method.heat.intrinsic_delaunay,
               "heat: use the mesh's own edges");
  app.add_option("--neighbours", options.method.svg.neighbours,
                 "svg: vertices looked at around each vertex")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--build-with", options.method.svg.builder,
                 "svg: whose windows find the arcs")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, SaddleGraphBuilder>{
              {"fwp", SaddleGraphBuilder::kFwp},
              {"ich", SaddleGraphBuilder::kIch}}));
  app.add_option("--samples", options.method.gtu.samples,
                 "gtu: vertices whose exact fields are computed")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--errors", options.errors,
               "also solve exactly, and print the mean and the largest "
               "relative error");
}

absl::Status CheckCombination(const CLI::App& app,
                              const std::string& algorithm) {
  const absl::StatusOr<ApproximateMethod> method =
      ApproximateMethodFromName(algorithm);
  for (const auto& [option, exact, methods] : AllTakers(app)) {
    const bool is_taken =
        method.ok() ? std::ranges::find(methods, *method) != methods.end()
                    : exact;
    if (!is_taken && app.count(option) > 0) {
      return absl::InvalidArgumentError(
          absl::StrCat(option, " is no option of ", algorithm));
    }
  }
  return absl::OkStatus();
}

absl::Status SolveApproximate(const Mesh& mesh, double setup_seconds,
                              const QuestionOptions& question,
                              const ApproximateOptions& options,
                              uint32_t threads, const std::string& output) {
  const absl::StatusOr<ApproximateMethod> method =
      ApproximateMethodFromName(question.algorithm);
  if (!method.ok()) return method.status();
  const absl::StatusOr<ValidQuery> query =
      ValidQuery::Make({.sources = {{VertexPoint{question.source}}}}, mesh);
  if (!query.ok()) return query.status();
  NoCheckpoint checkpoint;
  MethodOptions method_options = options.method;
  method_options.svg.threads = method_options.gtu.threads = threads;
  const auto start = std::chrono::steady_clock::now();
  const absl::StatusOr<std::shared_ptr<const PreparedMethod>> prepared =
      PrepareMethod(mesh, *method, method_options, checkpoint);
  if (!prepared.ok()) return prepared.status();
  const double prepare_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
          .count();
  ApproximateField field;
  std::vector<double> seconds;
  for (int i = 0; i < question.repeat; ++i) {
    absl::StatusOr<ApproximateField> solved =
        (*prepared)->Distances(*query, checkpoint);
    if (!solved.ok()) return solved.status();
    field = *std::move(solved);
    seconds.push_back(field.solve_seconds);
  }
  if (!output.empty()) {
    absl::Status status = WriteField(output, field.distances);
    if (!status.ok()) return status;
  }
  nlohmann::ordered_json line{
      {"faces", mesh.face_count()},
      {"vertices", mesh.vertex_count()},
      {"algorithm", std::string(ApproximateMethodName(field.method))},
      {"exact", false},
      {"certified_error", nullptr},
      {"setup_s", setup_seconds},
      {"prepare_s", prepare_seconds},
      {"prepared_bytes", (*prepared)->bytes()},
      {"solve_s", Median(seconds)},
      {"solve_s_all", seconds},
      {"peak_rss_mb", PeakRssMb()}};
  if (options.errors) {
    const absl::StatusOr<DistanceField> exact =
        Solve(mesh, *query, {}, checkpoint);
    if (!exact.ok()) return exact.status();
    const RelativeErrors errors =
        CompareDistances(field.distances, exact->distances);
    line["mean_error"] = errors.mean;
    line["max_error"] = errors.largest;
  }
  std::cout << line.dump() << "\n";
  return absl::OkStatus();
}

}  // namespace geodesic
