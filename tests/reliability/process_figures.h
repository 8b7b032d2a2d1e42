// What a process takes, as /proc says, now and over time.

#ifndef GEODESIC_TESTS_RELIABILITY_PROCESS_FIGURES_H_
#define GEODESIC_TESTS_RELIABILITY_PROCESS_FIGURES_H_

#include <sys/types.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

namespace geodesic::client {

struct ProcessFigures {
  double resident_mib = 0;
  double descriptors = 0;
  double threads = 0;
};

// Errors: throws std::runtime_error if there is no such process.
ProcessFigures ReadFigures(pid_t process);

// Takes samples on a thread of its own until it ends.
class FigureSeries {
 public:
  FigureSeries(pid_t process, std::chrono::milliseconds interval);
  ~FigureSeries();
  FigureSeries(const FigureSeries&) = delete;
  FigureSeries& operator=(const FigureSeries&) = delete;

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

  void Run(pid_t process, std::chrono::milliseconds interval);
  std::vector<Sample> samples() const;

  mutable std::mutex mutex_;
  std::condition_variable stop_;
  // Guarded by mutex_:
  bool stopped_ = false;
  std::vector<Sample> samples_;

  std::thread thread_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_RELIABILITY_PROCESS_FIGURES_H_
