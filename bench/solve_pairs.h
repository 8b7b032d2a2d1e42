// solve --target and --pairs: what the distance between two places costs.

#ifndef GEODESIC_BENCH_SOLVE_PAIRS_H_
#define GEODESIC_BENCH_SOLVE_PAIRS_H_

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>

#include "absl/status/status.h"
#include "bench/question_options.h"
#include "geodesic/mesh.h"

namespace geodesic {

struct PairOptions {
  std::optional<uint32_t> target;  // from the source of the question
  uint32_t pairs = 0;              // or so many random ones
  uint32_t landmarks = 0;
  uint32_t seed = 1;
  // How many of the pairs are also computed as a field that stops at the
  // target, and compared.
  uint32_t compare = 0;
  double tolerance = 0;
  // Whether pairs within a tolerance are also searched for exactly.
  bool errors = false;
};

// The tolerance and whether there are errors are options of fields, too.
void AddPairOptions(CLI::App& app, PairOptions& options);

// Prints a line of JSON; times are processor time. Landmarks are made before
// the clock starts.
absl::Status SolvePairs(const Mesh& mesh, const QuestionOptions& question,
                        const PairOptions& options);

}  // namespace geodesic

#endif  // GEODESIC_BENCH_SOLVE_PAIRS_H_
