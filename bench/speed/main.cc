// speed: measures solvers, pairs, uploads and memory on meshes, beside CGAL
// where it is installed, and writes Markdown tables. scripts/bench runs it.

#include <benchmark/benchmark.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "bench/speed/benchmarks.h"
#include "bench/speed/report.h"
#include "bench/subject.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::speed {
namespace {

struct Options {
  std::vector<std::string> files;
  std::string markdown;
  std::string filter = ".*";
  std::string command = "speed";
  int rounds = 3;
  int sources = 64;
  uint32_t pairs = 1000;
  uint32_t most_cgal_faces = 100'000;
  uint32_t most_sources_faces = 120'000;
};

std::vector<Subject> GeneratedSubjects() {
  return {
      Generated("icosphere", test::Icosphere(5)),
      Generated("terrain", test::Terrain(100, 100, 1, 1)),
      Generated("torus",
                test::Torus({.around = 160, .across = 60, .noise = 0.002}))};
}

int Run(const Options& options) {
  std::vector<Subject> subjects;
  if (options.files.empty()) {
    subjects = GeneratedSubjects();
  } else {
    absl::StatusOr<std::vector<Subject>> loaded = LoadSubjects(options.files);
    if (!loaded.ok()) {
      std::cerr << "speed: " << std::string(loaded.status().message()) << "\n";
      return 1;
    }
    subjects = *std::move(loaded);
  }
  for (const Subject& subject : subjects) {
    RegisterSolve(subject, options.rounds);
    RegisterLowerEnvelope(subject);
    RegisterPairs(subject, options.pairs);
    if (subject.mesh->face_count() <= options.most_sources_faces) {
      RegisterSources(subject, options.sources,
                      benchmark::CPUInfo::Get().num_cpus, options.rounds);
    }
#ifdef GEODESIC_CGAL_VERSION
    if (subject.mesh->face_count() <= options.most_cgal_faces) {
      RegisterCgal(subject);
      RegisterCgalPairs(subject);
    }
#endif
  }
#ifdef GEODESIC_WITH_ENGINE
  for (const std::string& file : options.files) {
    RegisterUpload(file, options.rounds);
  }
#endif
  Report report;
  benchmark::RunSpecifiedBenchmarks(&report, options.filter);
  if (options.markdown.empty()) return 0;
  std::ofstream out(options.markdown);
  WriteMarkdown(out, report, subjects, options.command);
  if (!out.flush()) {
    std::cerr << "speed: cannot write " << options.markdown << "\n";
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace geodesic::speed

int main(int argc, char** argv) {
  CLI::App app{
      "Measures solvers, pairs, uploads and memory, side by side in one "
      "process."};
  geodesic::speed::Options options;
  app.add_option("MESH_FILE", options.files,
                 "OBJ, PLY, OFF or STL files; generated meshes without any")
      ->check(CLI::ExistingFile);
  app.add_option("--markdown", options.markdown, "write tables to this file");
  app.add_option("--command", options.command, "what the tables say was run");
  app.add_option("--filter", options.filter,
                 "measure what matches this regular expression")
      ->capture_default_str();
  app.add_option("--rounds", options.rounds, "measure this many times")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--sources", options.sources,
                 "how many fields are computed side by side")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--pairs", options.pairs,
                 "how many random pairs of vertices are searched")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--cgal-faces", options.most_cgal_faces,
                 "run CGAL on meshes of up to so many faces")
      ->capture_default_str();
  app.add_option("--sources-faces", options.most_sources_faces,
                 "compute many fields on meshes of up to so many faces")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  // Turns at random, so that what disturbs one disturbs all.
  std::string name = "speed",
              interleaving = "--benchmark_enable_random_interleaving",
              least_time = "--benchmark_min_time=0.1";
  std::vector<char*> arguments = {name.data(), interleaving.data(),
                                  least_time.data()};
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  const int status = geodesic::speed::Run(options);
  benchmark::Shutdown();
  return status;
}
