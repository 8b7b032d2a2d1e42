// load: asks a server of its own by schedule, checks every answer, and says how
// long answers took and what the server took.
//
//   load --seconds 600 --rate 100                          as it comes, a soak
//   load --seconds 10 --rate 200 --mix cached=1            one figure
//   load --seconds 600 --overload 10                       too much
//
// --overload first measures the latency of a server with little to do, and its
// capacity: the right answers a second at the rate where it begins to refuse.
// Then so many times that come.
//
// Prints a line of JSON. Exit codes: 0 every answer was right, or a refusal
// that says when to come again; memory stayed within the budgets and a tenth,
// and what requests hold went back to zero; 1 not so, said on standard error; 2
// wrong usage.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "tests/reliability/open_loop.h"
#include "tests/reliability/watched_server.h"
#include "tests/reliability/workload.h"

namespace geodesic::client {
namespace {

struct Options {
  double seconds = 5;
  double rate = 50;
  double overload = 0;  // times the capacity; 0: the rate as it is
  uint32_t vertices = 4096;
  std::string mix = "cached=10,cold=4,path=2,matrix=2,upload=2";
  size_t connections = 8;
  uint64_t seed = 1;
  WatchedServer::Options server = {.program = GEODESICD_BINARY};
};

// What a server with nothing to do can be asked for to see its latency.
constexpr double kUnloadedRate = 10;
constexpr double kUnloadedSeconds = 30;
// The search for the capacity.
constexpr double kFirstRate = 20;
constexpr double kStepSeconds = 2;

class Load {
 public:
  Load(const Options& options, const Mix& mix)
      : options_(options),
        mix_(mix),
        random_(options.seed),
        workload_(options.vertices, options.seed),
        server_(options.server) {
    workload_.Prepare(server_.address());
    connections_ = Connect(server_.address(), options.connections);
  }

  nlohmann::ordered_json Run() {
    nlohmann::ordered_json result;
    double rate = options_.rate;
    if (options_.overload > 0) {
      const double seconds = std::min(options_.seconds, kUnloadedSeconds);
      result["unloaded"] = Phase(kUnloadedRate, seconds).Summary();
      const double capacity = Capacity();
      result["capacity_per_second"] = capacity;
      rate = options_.overload * capacity;
    }
    result["load"] = Phase(rate, options_.seconds).Summary();
    connections_.clear();
    result["server"] = server_.Summary();
    return result;
  }

  // What was not as it must be.
  std::vector<std::string> Faults() const {
    std::vector<std::string> faults = server_.Faults();
    faults.insert(faults.begin(), faults_.begin(), faults_.end());
    return faults;
  }

 private:
  LoadFigures Phase(double rate, double seconds) {
    LoadFigures figures =
        RunOpenLoop(connections_, workload_, mix_, rate, seconds, random_);
    const std::vector<std::string> faults = figures.Faults();
    faults_.insert(faults_.end(), faults.begin(), faults.end());
    return figures;
  }

  // The right answers a second at the first rate of which a tenth is refused.
  // At higher ones the server would still answer what costs nothing.
  double Capacity() {
    const double seconds = std::min(options_.seconds, kStepSeconds);
    for (double rate = kFirstRate;; rate *= 1.5) {
      const LoadFigures figures = Phase(rate, seconds);
      if (figures.answers() < 0.9 * static_cast<double>(figures.sent)) {
        return static_cast<double>(figures.answers()) / seconds;
      }
    }
  }

  const Options& options_;
  const Mix mix_;
  std::mt19937_64 random_;
  Workload workload_;
  WatchedServer server_;
  std::vector<std::unique_ptr<RawConnection>> connections_;
  std::vector<std::string> faults_;
};

std::vector<std::string> Run(const Options& options) {
  const absl::StatusOr<Mix> mix = ParseMix(options.mix);
  if (!mix.ok()) {
    throw CLI::ValidationError("--mix", std::string(mix.status().message()));
  }
  Load load(options, *mix);
  std::cout << load.Run() << std::endl;
  return load.Faults();
}

}  // namespace
}  // namespace geodesic::client

int main(int argc, char** argv) {
  geodesic::client::Options options;
  CLI::App app("Asks a server by schedule and checks its answers.", "load");
  app.option_defaults()->always_capture_default();
  app.add_option("--seconds", options.seconds, "Length of the load")
      ->check(CLI::PositiveNumber);
  app.add_option("--rate", options.rate, "Questions a second")
      ->check(CLI::PositiveNumber);
  app.add_option("--overload", options.overload,
                 "Instead: so many times what the server can do")
      ->check(CLI::PositiveNumber);
  app.add_option("--vertices", options.vertices, "Of the mesh asked about")
      ->check(CLI::Range(16, 1'000'000));
  app.add_option("--mix", options.mix,
                 "Parts of upload, cold, cached, path, matrix");
  app.add_option("--connections", options.connections, "To the server")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", options.seed, "Of moments and questions");
  app.add_flag("--durable", options.server.is_durable,
               "Give the server a data folder");
  app.add_option("--disk-mib", options.server.disk_mib,
                 "Room in it for meshes, and as much for fields")
      ->check(CLI::PositiveNumber);
  geodesic::client::AddServerOptions(app, options.server);
  app.add_option("FLAG", options.server.flags,
                 "For the server, after \"--\": beside those of its budgets");
  return geodesic::client::RunMain(
      app, argc, argv, [&] { return geodesic::client::Run(options); });
}
