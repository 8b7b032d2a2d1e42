#include "tests/reliability/watched_server.h"

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <regex>
#include <stdexcept>
#include <utility>

#include "absl/strings/str_cat.h"
#include "tests/support/http_get.h"

namespace geodesic::client {
namespace {

struct Budget {
  const char* limit;
  int mib;
};

// Small, so that a load of seconds fills them.
constexpr std::array<Budget, 4> kBudgets = {{{"mesh-store", 64},
                                             {"field-cache", 64},
                                             {"upload-memory", 96},
                                             {"solver-memory", 128}}};

constexpr std::array kBackToZero = {
    R"(geodesic_active_requests)",
    R"(geodesic_jobs{state="running"})",
    R"(geodesic_jobs{state="queued"})",
    R"(geodesic_waiters)",
    R"(geodesic_used_bytes{budget="uploads"})",
    R"(geodesic_used_bytes{budget="solvers"})",
};

// Between samples.
constexpr std::chrono::milliseconds kInterval{500};

// On a page of metrics. Errors: throws std::runtime_error if it is not there.
double ValueOn(const std::string& page, const std::string& name) {
  const size_t line = page.find(absl::StrCat("\n", name, " "));
  if (line == std::string::npos) {
    throw std::runtime_error("there is no metric " + name);
  }
  return std::stod(page.substr(line + name.size() + 2));
}

// Of the straight line that fits best, in the least squares.
double Slope(const std::vector<std::pair<double, double>>& points) {
  double n = 0;
  double sum_x = 0;
  double sum_y = 0;
  for (const auto& [x, y] : points) {
    n += 1;
    sum_x += x;
    sum_y += y;
  }
  double covariance = 0;
  double variance = 0;
  for (const auto& [x, y] : points) {
    covariance += (x - sum_x / n) * (y - sum_y / n);
    variance += (x - sum_x / n) * (x - sum_x / n);
  }
  return variance > 0 ? covariance / variance : 0;
}

}  // namespace

ProcessFigures ReadFigures(pid_t process) {
  const std::string folder = "/proc/" + std::to_string(process);
  std::ifstream status(folder + "/status");
  if (!status) throw std::runtime_error("the server is gone");
  ProcessFigures figures;
  std::string name;
  while (status >> name) {
    if (name == "VmRSS:") {
      double kib = 0;
      status >> kib;
      figures.resident_mib = kib / 1024;
    } else if (name == "Threads:") {
      status >> figures.threads;
    }
  }
  const std::filesystem::directory_iterator descriptors(folder + "/fd");
  figures.descriptors =
      static_cast<double>(std::distance(begin(descriptors), end(descriptors)));
  return figures;
}

FigureSeries::FigureSeries(pid_t process)
    : thread_([this, process](const std::stop_token& stop) {
        Run(process, stop);
      }) {}

void FigureSeries::Run(pid_t process, const std::stop_token& stop) {
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  for (int i = 1; !stop.stop_requested(); ++i) {
    const std::chrono::duration<double> since =
        std::chrono::steady_clock::now() - start;
    try {
      samples_.push_back({since.count(), ReadFigures(process)});
    } catch (const std::runtime_error&) {
      return;  // it has ended
    }
    stopped_.wait_until(lock, stop, start + i * kInterval,
                        [] { return false; });
  }
}

std::vector<FigureSeries::Sample> FigureSeries::samples() const {
  std::lock_guard lock(mutex_);
  return samples_;
}

double FigureSeries::PeakResidentMib() const {
  double peak = 0;
  for (const Sample& sample : samples()) {
    peak = std::max(peak, sample.figures.resident_mib);
  }
  return peak;
}

nlohmann::ordered_json FigureSeries::Summary() const {
  const std::vector<Sample> all = samples();
  nlohmann::ordered_json summary = {{"samples", all.size()}};
  if (all.empty()) return summary;
  const auto add = [&](const char* name, double ProcessFigures::*figure) {
    double most = 0;
    std::vector<std::pair<double, double>> later;
    for (size_t i = 0; i < all.size(); ++i) {
      const double value = all[i].figures.*figure;
      most = std::max(most, value);
      if (i >= all.size() / 2) later.emplace_back(all[i].seconds, value);
    }
    summary[name] = {{"first", all.front().figures.*figure},
                     {"last", all.back().figures.*figure},
                     {"most", most},
                     {"growth_per_hour", 3600 * Slope(later)}};
  };
  add("resident_mib", &ProcessFigures::resident_mib);
  add("descriptors", &ProcessFigures::descriptors);
  add("threads", &ProcessFigures::threads);
  return summary;
}

WatchedServer::WatchedServer(const Options& options)
    : ignores_memory_(options.ignores_memory), times_(options.times) {
  std::vector<std::string> all = {
      "--metrics-listen", "127.0.0.1:0", "--limit",
      absl::StrCat("max-upload-bytes=", 16 * times_, "MiB")};
  for (const Budget& budget : kBudgets) {
    all.insert(all.end(),
               {"--limit",
                absl::StrCat(budget.limit, "=", times_ * budget.mib, "MiB")});
  }
  if (options.is_durable) {
    const std::string disk = absl::StrCat(options.disk_mib, "MiB");
    all.insert(all.end(), {"--data-dir", folder_ / "data", "--limit",
                           "mesh-disk=" + disk + ",field-disk=" + disk});
  }
  all.insert(all.end(), options.flags.begin(), options.flags.end());
  server_ = std::make_unique<RunningServer>(folder_, all, options.program);
  const std::string log = test::FileBytes(folder_ / "server.log");
  std::smatch match;
  if (!std::regex_search(log, match, std::regex("metrics on port (\\d+)"))) {
    throw std::runtime_error("the log does not name the port of the metrics");
  }
  metrics_port_ = std::stoi(match[1]);
  series_ = std::make_unique<FigureSeries>(server_->id());
}

double WatchedServer::BudgetMib() const {
  double sum = 0;
  for (const Budget& budget : kBudgets) sum += times_ * budget.mib;
  return sum;
}

double WatchedServer::Metric(const std::string& name) const {
  return ValueOn(test::HttpGet(metrics_port_, "/metrics"), name);
}

std::map<std::string, double> WatchedServer::Held() const {
  const std::string page = test::HttpGet(metrics_port_, "/metrics");
  std::map<std::string, double> held;
  for (const char* name : kBackToZero) held[name] = ValueOn(page, name);
  return held;
}

int WatchedServer::Stop() const {
  server_->Terminate();
  return server_->Wait();
}

std::vector<std::string> WatchedServer::Leftovers() const {
  // What no request holds any more may be held by the landmarks that are made
  // in idle time. They go on one by one, for as long as it takes.
  constexpr std::chrono::seconds kLongestStandstill{10};
  const std::string landmarks =
      R"(geodesic_landmarks_total{origin="computed"})";
  double made = Metric(landmarks);
  auto until = std::chrono::steady_clock::now() + kLongestStandstill;
  for (;;) {
    std::vector<std::string> left;
    for (const auto& [name, value] : Held()) {
      if (value != 0) left.push_back(absl::StrCat(name, " is ", value));
    }
    if (left.empty() || std::chrono::steady_clock::now() > until) return left;
    if (const double now = Metric(landmarks); now != made) {
      made = now;
      until = std::chrono::steady_clock::now() + kLongestStandstill;
    }
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
      ->check(CLI::ExistingFile);
  app.add_flag("--ignore-memory", options.ignores_memory,
               "Its memory says nothing: a sanitizer's is beside any budget");
}

int RunMain(CLI::App& app, int argc, char** argv,
            const std::function<std::vector<std::string>()>& run) {
  std::vector<std::string> faults;
  try {
    app.parse(argc, argv);
    faults = run();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    faults = {error.what()};
  }
  for (const std::string& fault : faults) {
    std::cerr << app.get_name() << ": " << fault << '\n';
  }
  return faults.empty() ? 0 : 1;
}

}  // namespace geodesic::client
