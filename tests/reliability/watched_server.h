// What the programs of this folder share: a server with known budgets, watched
// from outside, and the way from a command line to an exit code.

#ifndef GEODESIC_TESTS_RELIABILITY_WATCHED_SERVER_H_
#define GEODESIC_TESTS_RELIABILITY_WATCHED_SERVER_H_

#include <sys/types.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "tests/integration/running_server.h"

namespace geodesic::client {

// What a process takes, as /proc says.
struct ProcessFigures {
  double resident_mib = 0;
  double descriptors = 0;
  double threads = 0;
};

// Errors: throws std::runtime_error if there is no such process.
ProcessFigures ReadFigures(pid_t process);

// Takes samples, two a second, on a thread of its own until it ends.
class FigureSeries {
 public:
  explicit FigureSeries(pid_t process);

  // So far. Thread-safe.
  double PeakResidentMib() const;

  // Of each figure the first, the last, the most, and the growth an hour that
  // fits the later half best: caches fill in the earlier.
  nlohmann::ordered_json Summary() const;

 private:
  struct Sample {
    double seconds;
    ProcessFigures figures;
  };

  void Run(pid_t process, const std::stop_token& stop);
  std::vector<Sample> samples() const;

  mutable std::mutex mutex_;
  std::condition_variable_any stopped_;
  std::vector<Sample> samples_;  // guarded by mutex_

  std::jthread thread_;
};

class WatchedServer {
 public:
  struct Options {
    std::string program;
    // Beside the budgets.
    std::vector<std::string> flags;
    // How many times the usual budgets it has.
    int times = 1;
    // Whether it has a data folder; for so much of meshes, and of fields.
    bool is_durable = false;
    int disk_mib = 256;
    // Whether its memory says nothing: a sanitizer's is beside any budget.
    bool ignores_memory = false;
  };

  explicit WatchedServer(const Options& options);

  const std::string& address() const { return server_->address(); }

  ProcessFigures Now() const { return ReadFigures(server_->id()); }

  // A number of the metrics page, e.g. `geodesic_jobs{state="queued"}`.
  // Errors: throws std::runtime_error if it is not there.
  double Metric(const std::string& name) const;

  // The numbers, by their names, of what requests hold: all are 0 once there
  // are none.
  std::map<std::string, double> Held() const;

  // Asks it to stop; its exit code, once it has. Nothing else may be asked of
  // it then but Summary.
  int Stop() const;

  // Once nobody asks any more: what requests held that is not back to zero
  // (requests, jobs, waiters, memory of uploads and solvers) ten seconds after
  // the last landmark was made, and whether the process ever took more memory
  // than its budgets, a tenth, and `more_mib`. A line each.
  std::vector<std::string> Faults(double more_mib = 0) const;

  nlohmann::ordered_json Summary() const;

 private:
  std::vector<std::string> Leftovers() const;
  double BudgetMib() const;  // all together

  const bool ignores_memory_;
  const int times_;
  TemporaryFolder folder_;
  std::unique_ptr<RunningServer> server_;
  int metrics_port_ = 0;
  std::unique_ptr<FigureSeries> series_;
};

// The options that every program with such a server has.
void AddServerOptions(CLI::App& app, WatchedServer::Options& options);

// Parses the command line, then calls `run`, which returns what was not as it
// must be: a line each on standard error. Returns the exit code: 0 nothing, 1
// something, or `run` threw; 2 wrong usage, which `run` may find too and throw
// as a CLI::ParseError.
int RunMain(CLI::App& app, int argc, char** argv,
            const std::function<std::vector<std::string>()>& run);

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_RELIABILITY_WATCHED_SERVER_H_
