// paper: runs an experiment of Xu et al. 2015 and prints its table, tabs
// between the columns. scripts/paper runs them all and plots them.

#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "bench/paper/experiments.h"
#include "bench/subject.h"

int main(int argc, char** argv) {
  using geodesic::paper::Setting;
  const std::map<std::string, void (*)(const Setting&)> experiments = {
      {"resolution", geodesic::paper::RunResolution},
      {"anisotropy", geodesic::paper::RunAnisotropy},
      {"models", geodesic::paper::RunModels},
      {"wavefront", geodesic::paper::RunWavefront},
      {"batch", geodesic::paper::RunBatch},
      {"bucket-width", geodesic::paper::RunBucketWidth},
      {"accuracy", geodesic::paper::RunAccuracy},
      {"methods", geodesic::paper::RunMethods},
      {"neighbours", geodesic::paper::RunNeighbours},
      {"marching", geodesic::paper::RunMarching},
      {"heat-time", geodesic::paper::RunHeatTime},
      {"trade-off", geodesic::paper::RunTradeOff}};
  std::string experiment;
  std::vector<std::string> files;
  Setting setting;
  CLI::App app{
      "Runs an experiment of the paper on Fast Wavefront Propagation (Xu et "
      "al., IEEE TVCG 21(7), 2015) and prints its table."};
  app.add_option("EXPERIMENT", experiment, "which one")
      ->required()
      ->check(CLI::IsMember(experiments));
  app.add_option("MESH_FILE", files, "models: OBJ, PLY, OFF or STL files")
      ->check(CLI::ExistingFile);
  app.add_flag("--quick", setting.quick,
               "small meshes and few steps: to see that it works");
  CLI11_PARSE(app, argc, argv);
  const auto models = geodesic::LoadSubjects(files);
  if (!models.ok()) {
    std::cerr << "paper: " << std::string(models.status().message()) << "\n";
    return 1;
  }
  setting.models = *models;
  experiments.at(experiment)(setting);
  return 0;
}
