// stress: draws meshes, questions and algorithms at random and checks the laws
// that geodesic distances obey, for as long as it is told. Every case is
// a number: --seed with --cases 1 runs it again.

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "tests/stress/laws.h"
#include "tests/stress/report.h"
#include "tests/stress/scene.h"
#include "tests/support/random.h"

namespace geodesic::stress {
namespace {

constexpr double kLongCase = 20;  // seconds; worth a line

struct Law {
  const char* name;
  void (*check)(const Scene&, test::Random&, Report&);
  bool small_only = false;
};
constexpr Law kLaws[] = {
    {"field", CheckFieldLaws},         {"reach", CheckReachLaws},
    {"curve", CheckCurveLaws},         {"question", CheckQuestionLaws},
    {"brute", CheckBruteForce, true},  {"pair", CheckPairLaws},
    {"tolerance", CheckToleranceLaws},
};

struct Options {
  std::string law;  // of kLaws; empty for all
  double seconds = 60;
  uint64_t cases = std::numeric_limits<uint64_t>::max();
  uint64_t seed = 1;
  double progress_seconds = 30;
};

void RunCase(const std::string& law, uint64_t seed, Report& report,
             uint64_t* refused) {
  test::Random random(seed);
  const Scene scene = DrawScene(random);
  report.StartCase(seed, scene.description);
  if (scene.mesh == nullptr) {
    ++*refused;
    return;
  }
  for (const auto& [name, check, small_only] : kLaws) {
    if (small_only && !scene.is_small()) continue;
    if (law.empty() || law == name) check(scene, random, report);
  }
}

void Print(const Report& report, double seconds, uint64_t refused) {
  std::cout << "stress: " << static_cast<uint64_t>(seconds) << " s, "
            << report.cases() << " cases (" << refused << " meshes refused), "
            << report.checks() << " checks, " << report.violations()
            << " violations" << std::endl;
}

int Run(const Options& options) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  Report report(options.law.empty() ? "" : " --law " + options.law);
  uint64_t refused = 0;
  double next_progress = options.progress_seconds;
  for (uint64_t i = 0; i < options.cases && seconds() < options.seconds; ++i) {
    const double before = seconds();
    RunCase(options.law, options.seed + i, report, &refused);
    if (seconds() - before > kLongCase) {
      std::cout << "stress: case " << options.seed + i << " took "
                << static_cast<uint64_t>(seconds() - before) << " s"
                << std::endl;
    }
    if (seconds() < next_progress) continue;
    Print(report, seconds(), refused);
    next_progress += options.progress_seconds;
  }
  for (const auto& [law, count] : report.checks_by_law()) {
    std::cout << "  " << law << ": " << count << " checks\n";
  }
  Print(report, seconds(), refused);
  return report.violations() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace geodesic::stress

int main(int argc, char** argv) {
  CLI::App app{
      "Checks the laws of exact geodesic distances on random meshes. Exits "
      "with 1 if one was violated."};
  geodesic::stress::Options options;
  std::vector<std::string> laws;
  for (const auto& law : geodesic::stress::kLaws) laws.emplace_back(law.name);
  app.add_option("--law", options.law, "check this one alone")
      ->check(CLI::IsMember(laws));
  app.add_option("--seconds", options.seconds, "stop after so long")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--cases", options.cases, "stop after so many cases");
  app.add_option("--seed", options.seed,
                 "number of the first case; the others follow")
      ->capture_default_str();
  app.add_option("--progress", options.progress_seconds,
                 "seconds between lines of progress")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return geodesic::stress::Run(options);
}
