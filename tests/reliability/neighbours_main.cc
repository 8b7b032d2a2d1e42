// neighbours: asks a server by schedule, in turn alone and beside clients that
// ask much and behave badly (disturbers.h), on a disk that is then slow to
// flush and to read. Says what that costs those who ask as ever.
//
//   neighbours --seconds 3600 --server build/release/bin/geodesicd
//
// By their tokens those who ask as ever are a client of their own.
//
// Prints a line of JSON: latencies of the load alone and beside the others,
// over all phases together, and what the others did. Exit codes: 0 every answer
// of the load was right, or a refusal that says when to come again, the others
// met no error but what they provoked, memory stayed within the budgets and a
// tenth, and after each phase what requests hold went back to zero; 1 not so,
// said on standard error; 2 wrong usage.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "digest/sha256.h"
#include "tests/client/temporary_folder.h"
#include "tests/reliability/disturbers.h"
#include "tests/reliability/open_loop.h"
#include "tests/reliability/watched_server.h"
#include "tests/reliability/workload.h"

namespace geodesic::client {
namespace {

struct Options {
  double seconds = 360;
  double phase_seconds = 60;
  double beside_seconds = 300;
  double rate = 40;
  int disk_ms = 300;
  bool is_always_slow = false;
  int send_seconds = 120;
  std::string mix = "cached=10,cold=4,path=2,matrix=2,upload=2";
  uint64_t seed = 1;
  // Large budgets: else the hard meshes would be read again and again.
  WatchedServer::Options server = {
      .program = GEODESICD_BINARY, .times = 4, .is_durable = true};
};

constexpr uint32_t kVertices = 4096;
constexpr size_t kConnections = 8;
constexpr char kToken[] = "load";

// Beside the budgets of every watched server: the hard questions have landmarks
// made, and what approximate algorithms prepare.
constexpr int kPreparedMib = 128;
constexpr int kLandmarkMib = 32;
// A message that is made and one that gRPC has taken.
constexpr double kReaderMib = 1.25;
constexpr double kMoreMib =
    1.1 * (kPreparedMib + kLandmarkMib) + kReaderMib * kReaders;

std::string TokenFile() {
  const auto scopes = nlohmann::json::array({"read", "upload", "delete"});
  nlohmann::json entries = nlohmann::json::array();
  for (const std::string token : {kToken, "reader", "uploader", "asker"}) {
    entries.push_back(
        {{"name", token}, {"scopes", scopes}, {"sha256", Sha256Hex(token)}});
  }
  return nlohmann::json({{"tokens", entries}}).dump();
}

// A server whose disk is slow while the file `slow` of the folder exists.
std::unique_ptr<WatchedServer> StartServer(const Options& options,
                                           const TemporaryFolder& folder) {
  WriteFile(folder / "tokens", TokenFile());
  WatchedServer::Options all = options.server;
  all.flags.insert(all.flags.end(),
                   {"--token-file", folder / "tokens", "--limit",
                    absl::StrCat("prepared-memory=", kPreparedMib,
                                 "MiB,landmark-memory=", kLandmarkMib,
                                 "MiB,send-seconds=", options.send_seconds)});
  setenv("LD_PRELOAD", GEODESIC_HELD_DISK_LIBRARY, 1);
  setenv("GEODESIC_SLOW_DISK", (folder / "slow").c_str(), 1);
  auto server = std::make_unique<WatchedServer>(all);
  unsetenv("LD_PRELOAD");
  unsetenv("GEODESIC_SLOW_DISK");
  return server;
}

class Neighbours {
 public:
  Neighbours(const Options& options, const Mix& mix)
      : options_(options),
        mix_(mix),
        random_(options.seed),
        workload_(kVertices, options.seed, kToken),
        server_(StartServer(options, folder_)),
        disturbers_(server_->address(), options.send_seconds, options.seed) {
    workload_.Prepare(server_->address());
    connections_ = Connect(server_->address(), kConnections);
  }

  nlohmann::ordered_json Run() {
    LoadFigures alone;
    LoadFigures beside;
    for (double left = options_.seconds; left > 0;) {
      if (options_.is_always_slow) SlowDisk();
      alone.Add(Phase(options_.phase_seconds, left));
      if (left <= 0) break;
      disturbers_.Start();
      SlowDisk();
      beside.Add(Phase(options_.beside_seconds, left));
      std::filesystem::remove(folder_ / "slow");
      disturbers_.Stop();
      // Waits, too, until nothing of what they asked goes on.
      AddFaults(server_->Faults(kMoreMib));
    }
    AddFaults(alone.Faults());
    AddFaults(beside.Faults());
    AddFaults(disturbers_.Faults());
    connections_.clear();
    return {{"alone", alone.Summary()},
            {"beside", beside.Summary()},
            {"p99_beside_by_alone", Ratios(alone, beside)},
            {"disturbers", disturbers_.Summary()},
            {"server", server_->Summary()}};
  }

  // What was not as it must be.
  const std::vector<std::string>& faults() const { return faults_; }

 private:
  void SlowDisk() const {
    WriteFile(folder_ / "slow", std::to_string(options_.disk_ms));
  }

  // For so long, but no longer than what is left of all, and takes it off.
  LoadFigures Phase(double seconds, double& left) {
    seconds = std::min(seconds, left);
    left -= seconds;
    return RunOpenLoop(connections_, workload_, mix_, options_.rate, seconds,
                       random_);
  }

  static nlohmann::ordered_json Ratios(const LoadFigures& alone,
                                       const LoadFigures& beside) {
    nlohmann::ordered_json ratios;
    for (size_t i = 0; i < kQuestionKinds; ++i) {
      const double p99 = alone.answered[i].Milliseconds(0.99);
      if (p99 == 0) continue;
      ratios[kQuestionNames[i]] = beside.answered[i].Milliseconds(0.99) / p99;
    }
    return ratios;
  }

  void AddFaults(const std::vector<std::string>& faults) {
    faults_.insert(faults_.end(), faults.begin(), faults.end());
  }

  const Options& options_;
  const Mix mix_;
  std::mt19937_64 random_;
  Workload workload_;
  TemporaryFolder folder_;
  std::unique_ptr<WatchedServer> server_;
  Disturbers disturbers_;
  std::vector<std::unique_ptr<RawConnection>> connections_;
  std::vector<std::string> faults_;
};

std::vector<std::string> Run(const Options& options) {
  const absl::StatusOr<Mix> mix = ParseMix(options.mix);
  if (!mix.ok()) {
    throw CLI::ValidationError("--mix", std::string(mix.status().message()));
  }
  Neighbours neighbours(options, *mix);
  std::cout << neighbours.Run() << std::endl;
  return neighbours.faults();
}

}  // namespace
}  // namespace geodesic::client

int main(int argc, char** argv) {
  geodesic::client::Options options;
  CLI::App app("Asks a server alone and beside clients that behave badly.",
               "neighbours");
  app.option_defaults()->always_capture_default();
  app.add_option("--seconds", options.seconds, "Of all phases together")
      ->check(CLI::PositiveNumber);
  app.add_option("--phase-seconds", options.phase_seconds,
                 "Of a phase with the load alone")
      ->check(CLI::PositiveNumber);
  app.add_option("--beside-seconds", options.beside_seconds,
                 "Of the one after it, beside the others")
      ->check(CLI::PositiveNumber);
  app.add_option("--rate", options.rate, "Questions of the load a second")
      ->check(CLI::PositiveNumber);
  app.add_option("--disk-ms", options.disk_ms,
                 "That a flush or a read takes beside the others")
      ->check(CLI::PositiveNumber);
  app.add_flag("--always-slow", options.is_always_slow,
               "The disk is as slow for the load alone: what waits for it, as "
               "uploads do, is compared with itself");
  app.add_option("--send-seconds", options.send_seconds,
                 "The server's limit, which ends stalled readers")
      ->check(CLI::PositiveNumber);
  app.add_option("--mix", options.mix,
                 "Parts of upload, cold, cached, path, matrix");
  app.add_option("--seed", options.seed, "Of moments and questions");
  geodesic::client::AddServerOptions(app, options.server);
  app.add_option("FLAG", options.server.flags,
                 "For the server, after \"--\": beside those of its budgets");
  return geodesic::client::RunMain(
      app, argc, argv, [&] { return geodesic::client::Run(options); });
}
