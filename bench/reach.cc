// reach: how the cost of a computation that stops early grows with the area it
// covers, as a Markdown table. A row covers ten times the vertices of the one
// before.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <memory>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "bench/measured.h"
#include "bench/question_options.h"
#include "geodesic/computation.h"
#include "geodesic/mesh.h"
#include "geodesic/mesh_file.h"

namespace geodesic {
namespace {

using Clock = std::chrono::steady_clock;

double MillisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start)
      .count();
}

// Medians over the repeats.
struct Cost {
  double start_ms = 0;    // ValidQuery::Make and StartComputation
  double advance_ms = 0;  // Advance
  uint64_t windows = 0;
};

class Bench {
 public:
  Bench(const QuestionOptions& options, const Mesh& mesh, Algorithm algorithm)
      : options_(options),
        mesh_(mesh),
        query_{.sources = {{VertexPoint{options.source}}},
               .algorithm = algorithm} {}

  absl::Status Run() {
    absl::StatusOr<DistanceField> whole = FieldWithin({});
    if (!whole.ok()) return whole.status();
    std::vector<std::pair<double, uint32_t>> by_distance;
    for (uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
      if (std::isinf(whole->distances[v])) continue;
      by_distance.emplace_back(whole->distances[v], v);
    }
    std::ranges::sort(by_distance);
    std::vector<size_t> rows;  // places in by_distance
    for (size_t count = 100; count < by_distance.size(); count *= 10) {
      rows.push_back(count - 1);
    }
    rows.push_back(by_distance.size() - 1);

    std::vector<double> continued_ms;
    if (absl::Status status = Continue(by_distance, rows, continued_ms);
        !status.ok()) {
      return status;
    }
    std::cout << "| vertices | share of all | windows | start, ms | radius, ms "
                 "| ns a window | continued, ms | one target, ms |\n"
                 "|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    for (size_t row = 0; row < rows.size(); ++row) {
      const auto& [radius, vertex] = by_distance[rows[row]];
      absl::StatusOr<Cost> limited = Measure(query_, {.radius = radius});
      if (!limited.ok()) return limited.status();
      Query to_target = query_;
      to_target.targets = {VertexPoint{vertex}};
      absl::StatusOr<Cost> targeted = Measure(to_target, {.targets = 1});
      if (!targeted.ok()) return targeted.status();
      const double windows = static_cast<double>(limited->windows);
      std::printf(
          "| %zu | %.3f%% | %.0f | %.2f | %.2f | %.0f | %.2f | %.2f |\n",
          rows[row] + 1,
          100 * static_cast<double>(rows[row] + 1) /
              static_cast<double>(by_distance.size()),
          windows, limited->start_ms, limited->advance_ms,
          limited->advance_ms * 1e6 / windows, continued_ms[row],
          targeted->advance_ms);
    }
    return absl::OkStatus();
  }

 private:
  absl::StatusOr<std::unique_ptr<Computation>> Start(const Query& query) const {
    const absl::StatusOr<ValidQuery> valid = ValidQuery::Make(query, mesh_);
    if (!valid.ok()) return valid.status();
    return StartComputation(mesh_, *valid, {});
  }

  absl::StatusOr<DistanceField> FieldWithin(const Reach& reach) const {
    NoCheckpoint checkpoint;
    absl::StatusOr<std::unique_ptr<Computation>> computation = Start(query_);
    if (!computation.ok()) return computation.status();
    if (absl::Status status = (*computation)->Advance(reach, checkpoint);
        !status.ok()) {
      return status;
    }
    return (*computation)->Field();
  }

  // Each time a computation of its own.
  absl::StatusOr<Cost> Measure(const Query& query, const Reach& reach) const {
    NoCheckpoint checkpoint;
    std::vector<double> start_ms, advance_ms;
    uint64_t windows = 0;
    for (int i = 0; i < options_.repeat; ++i) {
      const Clock::time_point start = Clock::now();
      absl::StatusOr<std::unique_ptr<Computation>> computation = Start(query);
      if (!computation.ok()) return computation.status();
      start_ms.push_back(MillisecondsSince(start));
      const Clock::time_point advance = Clock::now();
      if (absl::Status status = (*computation)->Advance(reach, checkpoint);
          !status.ok()) {
        return status;
      }
      advance_ms.push_back(MillisecondsSince(advance));
      windows = (*computation)->Field().statistics.windows_propagated;
    }
    return Cost{Median(start_ms), Median(advance_ms), windows};
  }

  // One computation that goes on from row to row; what each step took.
  absl::Status Continue(
      const std::vector<std::pair<double, uint32_t>>& by_distance,
      const std::vector<size_t>& rows, std::vector<double>& step_ms) const {
    NoCheckpoint checkpoint;
    std::vector<std::vector<double>> all(rows.size());
    for (int i = 0; i < options_.repeat; ++i) {
      absl::StatusOr<std::unique_ptr<Computation>> computation = Start(query_);
      if (!computation.ok()) return computation.status();
      for (size_t row = 0; row < rows.size(); ++row) {
        const Clock::time_point start = Clock::now();
        if (absl::Status status =
                (*computation)
                    ->Advance({by_distance[rows[row]].first}, checkpoint);
            !status.ok()) {
          return status;
        }
        all[row].push_back(MillisecondsSince(start));
      }
    }
    for (std::vector<double>& row : all) step_ms.push_back(Median(row));
    return absl::OkStatus();
  }

  const QuestionOptions& options_;
  const Mesh& mesh_;
  const Query query_;
};

absl::Status Run(const QuestionOptions& options) {
  absl::StatusOr<Algorithm> algorithm = AlgorithmFromName(options.algorithm);
  if (!algorithm.ok()) return algorithm.status();
  absl::StatusOr<std::shared_ptr<const Mesh>> mesh =
      ReadMeshFile(options.mesh_file);
  if (!mesh.ok()) return mesh.status();
  return Bench(options, **mesh, *algorithm).Run();
}

}  // namespace
}  // namespace geodesic

int main(int argc, char** argv) {
  CLI::App app{
      "Measures computations that stop at a radius or a target, and such that "
      "go on, and prints a Markdown table."};
  geodesic::QuestionOptions options{.repeat = 5};
  geodesic::AddQuestionOptions(app, options);
  CLI11_PARSE(app, argc, argv);
  if (absl::Status status = geodesic::Run(options); !status.ok()) {
    std::cerr << "reach: " << std::string(status.message()) << "\n";
    return 1;
  }
  return 0;
}
