#include "bench/question_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace geodesic {

void AddQuestionOptions(CLI::App& app, QuestionOptions& options,
                        std::vector<std::string> others) {
  std::vector<std::string> names;
  names.reserve(kAlgorithms.size() + others.size());
  for (const AlgorithmInfo& info : kAlgorithms) names.emplace_back(info.name);
  std::ranges::move(others, std::back_inserter(names));
  app.add_option("MESH_FILE", options.mesh_file, "OBJ, PLY, OFF or STL file")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("SOURCE", options.source, "source vertex, 0-based")
      ->required();
  app.add_option("--algorithm", options.algorithm, "which one solves")
      ->check(CLI::IsMember(names))
      ->capture_default_str();
  app.add_option("--repeat", options.repeat, "measure this many times")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

}  // namespace geodesic
