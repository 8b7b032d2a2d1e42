#include "bench/solve_approximate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "bench/measured.h"
#include "geodesic/solve.h"

namespace geodesic {
namespace {

struct Errors {
  double mean = 0;
  double largest = 0;
};

// Relative, over the vertices that are reached and are no source. Infinite if
// the two differ in which vertices are reached.
Errors Compare(const std::vector<double>& distances,
               const std::vector<double>& exact) {
  Errors errors;
  uint64_t count = 0;
  for (size_t v = 0; v < exact.size(); ++v) {
    if (exact[v] == 0 || (std::isinf(exact[v]) && std::isinf(distances[v]))) {
      continue;
    }
    const double error = std::abs(distances[v] / exact[v] - 1);
    errors.mean += error;
    errors.largest = std::max(errors.largest, error);
    ++count;
  }
  if (count > 0) errors.mean /= static_cast<double>(count);
  return errors;
}

// Which methods take an option; the exact algorithms take none of these.
struct OptionOfMethods {
  std::string_view option;
  std::vector<ApproximateMethod> methods;
};
const std::vector<OptionOfMethods>& OptionsOfMethods() {
  static const auto& kOptions = *new std::vector<OptionOfMethods>{};
  return kOptions;
}

}  // namespace

std::vector<std::string> ApproximateMethodNames() {
  std::vector<std::string> names;
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
  app.add_flag("--errors", options.errors,
               "also solve exactly, and print the mean and the largest "
               "relative error");
}

absl::Status CheckCombination(const CLI::App& app,
                              const std::string& algorithm) {
  const absl::StatusOr<ApproximateMethod> method =
      ApproximateMethodFromName(algorithm);
  const auto refuse = [&](std::string_view option) {
    return absl::InvalidArgumentError(
        absl::StrCat(std::string(option), " is no option of ", algorithm));
  };
  for (const auto& [option, methods] : OptionsOfMethods()) {
    if (app.count(std::string(option)) == 0) continue;
    if (!method.ok() || std::ranges::find(methods, *method) == methods.end()) {
      return refuse(option);
    }
  }
  if (!method.ok()) {
    return app.count("--errors") > 0 ? refuse("--errors") : absl::OkStatus();
  }
  for (const std::string_view exact :
       {"--threads", "--bucket-width", "--max-batch", "--fixed-batch",
        "--target", "--pairs", "--landmarks", "--seed", "--compare"}) {
    if (app.count(std::string(exact)) > 0) return refuse(exact);
  }
  return absl::OkStatus();
}

absl::Status SolveApproximate(const Mesh& mesh, double setup_seconds,
                              const QuestionOptions& question,
                              const ApproximateOptions& options,
                              const std::string& output) {
  const absl::StatusOr<ApproximateMethod> method =
      ApproximateMethodFromName(question.algorithm);
  if (!method.ok()) return method.status();
  const absl::StatusOr<ValidQuery> query =
      ValidQuery::Make({.sources = {{VertexPoint{question.source}}}}, mesh);
  if (!query.ok()) return query.status();
  NoCheckpoint checkpoint;
  const auto start = std::chrono::steady_clock::now();
  const absl::StatusOr<std::shared_ptr<const PreparedMethod>> prepared =
      PrepareMethod(mesh, *method, options.method, checkpoint);
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
    const Errors errors = Compare(field.distances, exact->distances);
    line["mean_error"] = errors.mean;
    line["max_error"] = errors.largest;
  }
  std::cout << line.dump() << "\n";
  return absl::OkStatus();
}

}  // namespace geodesic
