// solve --algorithm with an approximate method: what it costs to prepare and
// to ask, and how far off it is.

#ifndef GEODESIC_BENCH_SOLVE_APPROXIMATE_H_
#define GEODESIC_BENCH_SOLVE_APPROXIMATE_H_

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "bench/question_options.h"
#include "geodesic/approximate/prepare.h"
#include "geodesic/mesh.h"
#include "geodesic_types/algorithms.h"

namespace geodesic {

struct ApproximateOptions {
  MethodOptions method;
  // Whether to solve exactly too, and compare.
  bool errors = false;
};

std::vector<std::string> ApproximateMethodNames();

// Adds what approximate methods alone take.
void AddApproximateOptions(CLI::App& app, ApproximateOptions& options);

// Errors: INVALID_ARGUMENT naming an option that was given and that this
// algorithm, exact or not, does not take. REQUIRES: the names are known.
absl::Status CheckCombination(const CLI::App& app,
                              const std::string& algorithm);

// Prepares the method, with so many threads where it takes them, writes the
// field to `output` unless that is empty, and prints a line of JSON.
absl::Status SolveApproximate(const Mesh& mesh, double setup_seconds,
                              const QuestionOptions& question,
                              const ApproximateOptions& options,
                              uint32_t threads, const std::string& output);

}  // namespace geodesic

#endif  // GEODESIC_BENCH_SOLVE_APPROXIMATE_H_
