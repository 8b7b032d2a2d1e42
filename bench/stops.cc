// stops: how soon every question of the core hears that it is to stop, on
// meshes where many faces meet, as a Markdown table. A row holds the question,
// its processor time, how often it asks, and the longest that it goes without
// asking.

#include <time.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"
#include "tests/support/every_question.h"
#include "tests/support/meshes/crowded_meshes.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic {
namespace {

// Of this thread, so that others who use the processor play no part.
double ProcessorMs() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) +
         1e-6 * static_cast<double>(now.tv_nsec);
}

// Measures the time between polls, and stops the question after `limit_ms`.
class Watch final : public Checkpoint {
 public:
  explicit Watch(double limit_ms) : limit_ms_(limit_ms) {}

  absl::Status Poll(const Progress&) override {
    Begin();
    ++polls_;
    return last_ - first_ > limit_ms_ ? absl::CancelledError("stopped")
                                      : absl::OkStatus();
  }
  // A part of the question ends here, or has a poll.
  void Begin() {
    const double now = ProcessorMs();
    // What is done before the first poll may be no part of the question.
    if (polls_ == 0) first_ = last_ = now;
    if (now - last_ > longest_) longest_ = now - last_;
    last_ = now;
  }

  uint64_t polls() const { return polls_; }
  double longest_ms() const { return longest_; }
  double all_ms() const { return last_ - first_; }

 private:
  const double limit_ms_;
  uint64_t polls_ = 0;
  double first_ = 0, last_ = 0, longest_ = 0;
};

struct Crowd {
  std::string name;
  TriangleSoup soup;
  uint32_t source;
};

std::vector<Crowd> Crowds(uint32_t faces) {
  const auto side = static_cast<uint32_t>(std::sqrt(faces / 2));
  const auto points = static_cast<uint32_t>(std::cbrt(6.0 * faces) + 1);
  return {{"pages", test::Pages(faces), 2},
          {"pages, spine", test::Pages(faces), 0},
          {"needles", test::NeedleFan(faces), 0},
          {"needles, rim", test::NeedleFan(faces), 1},
          {"one point", test::FanInOnePoint(faces), 1},
          {"fins", test::FinnedStrip(faces / 4), 0},
          {"strip", test::Strip(faces / 2, 0.1, 1), 0},
          {"grid", test::MakeGrid({.columns = side, .rows = side}), 0},
          {"all triangles", test::AllTriangles(points), 0}};
}

int Main(int argc, char** argv) {
  CLI::App app("How soon every question hears that it is to stop");
  uint32_t faces = 20'000, sources = 2000;
  double limit_s = 20;
  std::string only_mesh, only_question;
  bool all_algorithms = false;
  app.add_option("--faces", faces, "of each mesh, about")
      ->capture_default_str();
  app.add_option("--sources", sources, "where there are many")
      ->capture_default_str();
  app.add_option("--limit", limit_s,
                 "seconds after which a question is told to stop")
      ->capture_default_str();
  app.add_option("--mesh", only_mesh, "this one alone");
  app.add_option("--question", only_question,
                 "only those with this in their names");
  app.add_flag("--algorithms", all_algorithms, "fields by every algorithm");
  CLI11_PARSE(app, argc, argv);
  std::printf(
      "| mesh | question | ms | polls | longest between polls, ms | |\n"
      "|---|---|--:|--:|--:|---|\n");
  std::vector<test::AnyQuestion> questions =
      test::EveryQuestion(all_algorithms);
  std::ranges::move(test::QuestionsOfManySources(sources, all_algorithms),
                    std::back_inserter(questions));
  for (const Crowd& crowd : Crowds(faces)) {
    if (!only_mesh.empty() && crowd.name != only_mesh) continue;
    const std::shared_ptr<const Mesh> mesh = Mesh::Build(crowd.soup).value();
    for (const test::AnyQuestion& question : questions) {
      if (question.name.find(only_question) == std::string::npos) continue;
      Watch watch(1e3 * limit_s);
      const absl::Status status = question.ask(*mesh, crowd.source, watch);
      watch.Begin();
      std::printf("| %s | %s | %.0f | %llu | %.1f | %s |\n", crowd.name.c_str(),
                  question.name.c_str(), watch.all_ms(),
                  static_cast<unsigned long long>(watch.polls()),
                  watch.longest_ms(),
                  absl::StatusCodeToString(status.code()).c_str());
      std::fflush(stdout);
    }
  }
  return 0;
}

}  // namespace
}  // namespace geodesic

int main(int argc, char** argv) { return geodesic::Main(argc, argv); }
