#include "tests/reliability/watched_server.h"

#include <array>
#include <regex>
#include <stdexcept>
#include <thread>

#include "absl/strings/str_cat.h"
#include "tests/support/http_get.h"

namespace geodesic::client {
namespace {

struct Budget {
  const char* flag;
  int mib;
};

// Small, so that a load of seconds fills them.
constexpr std::array<Budget, 4> kBudgets = {{{"--mesh-store", 64},
                                             {"--field-cache", 64},
                                             {"--upload-memory", 96},
                                             {"--solver-memory", 128}}};

constexpr std::array kBackToZero = {
    R"(geodesic_active_requests)",
    R"(geodesic_jobs{state="running"})",
    R"(geodesic_jobs{state="queued"})",
    R"(geodesic_waiters)",
    R"(geodesic_used_bytes{budget="uploads"})",
    R"(geodesic_used_bytes{budget="solvers"})",
};

// All budgets together.
double BudgetMib() {
  double sum = 0;
  for (const Budget& budget : kBudgets) sum += budget.mib;
  return sum;
}

}  // namespace

WatchedServer::WatchedServer(const Options& options)
    : ignores_memory_(options.ignores_memory) {
  std::vector<std::string> all = {"--metrics-listen", "127.0.0.1:0",
                                  "--max-upload-bytes", "16MiB"};
  for (const Budget& budget : kBudgets) {
    all.insert(all.end(), {budget.flag, absl::StrCat(budget.mib, "MiB")});
  }
  if (options.is_durable) {
    const std::string disk = absl::StrCat(options.disk_mib, "MiB");
    all.insert(all.end(), {"--data-dir", folder_ / "data", "--mesh-disk", disk,
                           "--field-disk", disk});
  }
  all.insert(all.end(), options.flags.begin(), options.flags.end());
  server_ = std::make_unique<RunningServer>(folder_, all, options.program);
  const std::string log = test::FileBytes(folder_ / "server.log");
  std::smatch match;
  if (!std::regex_search(log, match, std::regex("metrics on port (\\d+)"))) {
    throw std::runtime_error("the log does not name the port of the metrics");
  }
  metrics_port_ = std::stoi(match[1]);
  series_ = std::make_unique<FigureSeries>(server_->id(), options.interval);
}

double WatchedServer::Metric(const std::string& name) const {
  const std::string page = test::HttpGet(metrics_port_, "/metrics");
  const size_t line = page.find(absl::StrCat("\n", name, " "));
  if (line == std::string::npos) {
    throw std::runtime_error("there is no metric " + name);
  }
  return std::stod(page.substr(line + name.size() + 2));
}

std::vector<std::string> WatchedServer::Leftovers() const {
  const auto until =
      std::chrono::steady_clock::now() + std::chrono::seconds(10);
  for (;;) {
    std::vector<std::string> left;
    for (const char* name : kBackToZero) {
      const double value = Metric(name);
      if (value != 0) left.push_back(absl::StrCat(name, " is ", value));
    }
    if (left.empty() || std::chrono::steady_clock::now() > until) return left;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

std::vector<std::string> WatchedServer::Faults(double more_mib) const {
  std::vector<std::string> faults;
  for (const std::string& left : Leftovers()) {
    faults.push_back("not back to zero: " + left);
  }
  const double most = 1.1 * BudgetMib() + more_mib;
  const double peak = series_->PeakResidentMib();
  if (!ignores_memory_ && peak > most) {
    faults.push_back(absl::StrCat("memory: ", peak, " MiB, more than ", most));
  }
  return faults;
}

nlohmann::ordered_json WatchedServer::Summary() const {
  nlohmann::ordered_json summary = series_->Summary();
  summary["budget_mib"] = BudgetMib();
  return summary;
}

void AddServerOptions(CLI::App& app, WatchedServer::Options& options) {
  app.add_option("--server", options.program, "The geodesicd to ask")
      ->check(CLI::ExistingFile)
      ->capture_default_str();
  app.add_flag("--ignore-memory", options.ignores_memory,
               "Its memory says nothing: a sanitizer's is beside any budget");
}

}  // namespace geodesic::client
