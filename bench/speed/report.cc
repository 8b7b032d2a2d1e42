#include "bench/speed/report.h"

#include <algorithm>

namespace geodesic::speed {

void Report::ReportRuns(const std::vector<Run>& runs) {
  ConsoleReporter::ReportRuns(runs);
  for (const Run& run : runs) {
    if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
    Measurement& measurement = measurements_[run.run_name.function_name];
    // All benchmarks here count in milliseconds. Others may share the machine:
    // processor time is what it costs, but where threads run side by side.
    const bool is_parallel = run.run_name.function_name.starts_with("sources/");
    measurement.milliseconds.push_back(is_parallel ? run.GetAdjustedRealTime()
                                                   : run.GetAdjustedCPUTime());
    for (const auto& [name, counter] : run.counters) {
      measurement.counters[name] = counter.value;
    }
  }
}

std::optional<double> Report::Milliseconds(const std::string& name) const {
  const auto it = measurements_.find(name);
  if (it == measurements_.end()) return std::nullopt;
  std::vector<double> sorted = it->second.milliseconds;
  std::ranges::sort(sorted);
  return sorted[sorted.size() / 2];
}

std::optional<double> Report::Counter(const std::string& name,
                                      const std::string& counter) const {
  const auto it = measurements_.find(name);
  if (it == measurements_.end()) return std::nullopt;
  const auto value = it->second.counters.find(counter);
  if (value == it->second.counters.end()) return std::nullopt;
  return value->second;
}

}  // namespace geodesic::speed
