// A server with known budgets, watched from outside.

#ifndef GEODESIC_TESTS_RELIABILITY_WATCHED_SERVER_H_
#define GEODESIC_TESTS_RELIABILITY_WATCHED_SERVER_H_

#include <chrono>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/integration/running_server.h"
#include "tests/reliability/process_figures.h"

namespace geodesic::client {

class WatchedServer {
 public:
  struct Options {
    std::string program;
    // Beside the budgets.
    std::vector<std::string> flags;
    // Whether it has a data folder.
    bool is_durable = false;
    // Of samples.
    std::chrono::milliseconds interval{500};
  };

  explicit WatchedServer(const Options& options);

  const std::string& address() const { return server_->address(); }

  // All its budgets together.
  static double BudgetMib();

  ProcessFigures Now() const { return ReadFigures(server_->id()); }
  double PeakResidentMib() const { return series_->PeakResidentMib(); }

  // A number of the metrics page, e.g. `geodesic_jobs{state="queued"}`.
  // Errors: throws std::runtime_error if it is not there.
  double Metric(const std::string& name) const;

  // Once nobody asks any more: what is not back to zero within ten seconds,
  // of requests, jobs, waiters, and memory of uploads and solvers.
  std::vector<std::string> Leftovers() const;

  nlohmann::ordered_json Summary() const;

 private:
  TemporaryFolder folder_;
  std::unique_ptr<RunningServer> server_;
  int metrics_port_ = 0;
  std::unique_ptr<FigureSeries> series_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_RELIABILITY_WATCHED_SERVER_H_
