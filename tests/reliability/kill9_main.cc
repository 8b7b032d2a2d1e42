// kill9: kills a server under mixed load at random moments, starts it again on
// what it left, and compares that with what it had acknowledged.
//
//   kill9 --rounds 200 --server build/release/bin/geodesicd
//
// Prints a line of JSON. Exit codes: 0 nothing was lost and nothing corrupt was
// served; 1 something was, said on standard error; 2 wrong usage.

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "geodesic_client/client.h"
#include "tests/integration/running_server.h"
#include "tests/reliability/mixed_load.h"
#include "tests/reliability/watched_server.h"

namespace geodesic::client {
namespace {

struct Options {
  uint64_t rounds = 200;
  uint64_t clients = 6;
  uint64_t meshes = 60;
  uint64_t seed = 1;
  // From the server, before it is killed.
  uint64_t most_answers = 400;
  std::string server = GEODESICD_BINARY;
};

size_t FilesIn(const std::string& folder, const std::string& ending) {
  size_t count = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    count += file.path().extension() == ending || ending.empty() ? 1 : 0;
  }
  return count;
}

class Kill9 {
 public:
  explicit Kill9(const Options& options)
      : options_(options),
        random_(options.seed),
        ledger_(MakeLedger(options.meshes)) {}

  // One life of the server; false if something was wrong with what it found or
  // in what it answered.
  bool Round() {
    RunningServer server = Start();
    std::vector<std::string> wrong = Check(server);
    MixedLoad load(server.address(), ledger_, counts_, options_.clients,
                   random_());
    load.AwaitAnswers(random_() % options_.most_answers);
    load.ExpectDeath();
    server.Kill();
    load.Join();
    wrong.insert(wrong.end(), load.wrong().begin(), load.wrong().end());
    return Report(wrong);
  }

  // A last life that only looks at what the one before left.
  bool LastRound() {
    RunningServer server = Start();
    return Report(Check(server));
  }

  const LoadCounts& counts() const { return counts_; }

 private:
  RunningServer Start() const {
    // Less memory than the meshes take, so that some are always on their way
    // back from the disk.
    return RunningServer(folder_,
                         {"--data-dir", folder_ / "data", "--limit",
                          "mesh-store=16MiB", "--log-level", "warn"},
                         options_.server);
  }

  std::vector<std::string> Check(const RunningServer& server) {
    // Nobody has asked anything yet: what was half written is gone.
    size_t temporaries = 0;
    for (const char* folder : {"meshes", "fields"}) {
      temporaries += FilesIn(folder_ / "data" + "/" + folder, ".tmp");
    }
    Client client(server.address());
    std::vector<std::string> wrong = CheckLedger(client, ledger_);
    if (temporaries > 0) wrong.push_back("a temporary file outlived a start");
    // A crash damages nothing.
    if (FilesIn(folder_ / "data" + "/quarantine", "") > 0) {
      wrong.push_back("a file was damaged");
    }
    return wrong;
  }

  static bool Report(const std::vector<std::string>& wrong) {
    for (const std::string& line : wrong) std::cerr << line << '\n';
    return wrong.empty();
  }

  const Options options_;
  std::mt19937_64 random_;
  TemporaryFolder folder_;
  std::vector<LedgerMesh> ledger_;
  LoadCounts counts_;
};

std::vector<std::string> Run(const Options& options) {
  if (options.meshes < options.clients) {
    throw CLI::ValidationError("--meshes must not be below --clients");
  }
  Kill9 kill9(options);
  uint64_t bad_rounds = 0;
  const auto start = std::chrono::steady_clock::now();
  for (uint64_t round = 0; round < options.rounds; ++round) {
    if (kill9.Round()) continue;
    ++bad_rounds;
    std::cerr << "in round " << round << " of seed " << options.seed << '\n';
  }
  if (!kill9.LastRound()) ++bad_rounds;
  const LoadCounts& counts = kill9.counts();
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - start;
  std::cout << nlohmann::json(
                   {{"rounds", options.rounds},
                    {"bad_rounds", bad_rounds},
                    {"seed", options.seed},
                    {"seconds", seconds.count()},
                    {"uploads_acknowledged", counts.uploads.load()},
                    {"deletions_acknowledged", counts.deletions.load()},
                    {"changes_unanswered", counts.unanswered.load()},
                    {"fields_checked", counts.fields.load()},
                    {"meshes_read", counts.reads.load()}})
            << '\n';
  if (bad_rounds == 0) return {};
  return {absl::StrCat("wrong after ", bad_rounds, " lives of the server")};
}

}  // namespace
}  // namespace geodesic::client

int main(int argc, char** argv) {
  geodesic::client::Options options;
  CLI::App app("Kills a server under load and checks what it kept.", "kill9");
  app.option_defaults()->always_capture_default();
  app.add_option("--rounds", options.rounds, "Lives of the server");
  app.add_option("--clients", options.clients, "Clients at once")
      ->check(CLI::PositiveNumber);
  app.add_option("--meshes", options.meshes, "Meshes, a share for each client")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", options.seed, "Of the load and the moments");
  app.add_option("--most-answers", options.most_answers,
                 "Answers from the server before it is killed, at most")
      ->check(CLI::PositiveNumber);
  app.add_option("--server", options.server, "The geodesicd to kill")
      ->check(CLI::ExistingFile);
  return geodesic::client::RunMain(
      app, argc, argv, [&] { return geodesic::client::Run(options); });
}
