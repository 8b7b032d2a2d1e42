// Keeps what Google Benchmark measures and writes it as Markdown tables.

#ifndef GEODESIC_BENCH_SPEED_REPORT_H_
#define GEODESIC_BENCH_SPEED_REPORT_H_

#include <benchmark/benchmark.h>

#include <map>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "bench/subject.h"

namespace geodesic::speed {

class Report final : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override;

  // Names as in benchmarks.h. Nothing where it was not measured.
  std::optional<double> Milliseconds(const std::string& name) const;  // median
  std::optional<double> Counter(const std::string& name,
                                const std::string& counter) const;

 private:
  struct Measurement {
    std::vector<double> milliseconds;
    std::map<std::string, double> counters;
  };

  std::map<std::string, Measurement> measurements_;
};

// `command` is what was run.
void WriteMarkdown(std::ostream& out, const Report& report,
                   std::span<const Subject> subjects,
                   const std::string& command);

}  // namespace geodesic::speed

#endif  // GEODESIC_BENCH_SPEED_REPORT_H_
