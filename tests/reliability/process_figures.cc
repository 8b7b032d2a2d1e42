#include "tests/reliability/process_figures.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace geodesic::client {
namespace {

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

FigureSeries::FigureSeries(pid_t process, std::chrono::milliseconds interval)
    : thread_([this, process, interval] { Run(process, interval); }) {}

FigureSeries::~FigureSeries() {
  {
    std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  stop_.notify_all();
  thread_.join();
}

void FigureSeries::Run(pid_t process, std::chrono::milliseconds interval) {
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  for (int i = 1; !stopped_; ++i) {
    const std::chrono::duration<double> since =
        std::chrono::steady_clock::now() - start;
    try {
      samples_.push_back({since.count(), ReadFigures(process)});
    } catch (const std::runtime_error&) {
      return;  // it has ended
    }
    stop_.wait_until(lock, start + i * interval, [this] { return stopped_; });
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

}  // namespace geodesic::client
