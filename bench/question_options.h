// The command line that programs which measure one question have in common.

#ifndef GEODESIC_BENCH_QUESTION_OPTIONS_H_
#define GEODESIC_BENCH_QUESTION_OPTIONS_H_

#include <CLI/App.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "geodesic_types/algorithms.h"

namespace geodesic {

struct QuestionOptions {
  std::string mesh_file;
  uint32_t source = 0;
  std::string algorithm{AlgorithmName(kDefaultAlgorithm)};
  int repeat = 1;
};

// Adds MESH_FILE, SOURCE, --algorithm and --repeat. `options` holds the
// defaults and outlives the parsing. --algorithm takes the exact ones and
// `others`.
void AddQuestionOptions(CLI::App& app, QuestionOptions& options,
                        std::vector<std::string> others = {});

}  // namespace geodesic

#endif  // GEODESIC_BENCH_QUESTION_OPTIONS_H_
