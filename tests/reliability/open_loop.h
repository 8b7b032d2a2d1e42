// A load by schedule: questions come when they come, whether or not the server
// has answered those before. Latency counts from the moment a question was to
// come, so that one that a slow server, or this program, holds up is not
// counted as quick.

#ifndef GEODESIC_TESTS_RELIABILITY_OPEN_LOOP_H_
#define GEODESIC_TESTS_RELIABILITY_OPEN_LOOP_H_

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "tests/reliability/latency_histogram.h"
#include "tests/reliability/raw_call.h"
#include "tests/reliability/workload.h"

namespace geodesic::client {

struct LoadFigures {
  // Answers that were checked and are right, by kind.
  std::array<LatencyHistogram, kQuestionKinds> answered;
  // RESOURCE_EXHAUSTED that says when to come again.
  LatencyHistogram refused;
  uint64_t sent = 0;
  double seconds = 0;  // of the schedule, without what came after
  // The latest that a question was sent after its moment.
  std::chrono::nanoseconds latest{0};
  // All else: wrong answers and errors. The first of them in words.
  uint64_t faults = 0;
  std::vector<std::string> fault_examples;

  // Those of another phase, too.
  void Add(const LoadFigures& other);

  uint64_t answers() const;
  // In words; empty if there are none.
  std::vector<std::string> Faults() const;
  nlohmann::ordered_json Summary() const;
};

// So many connections to the server.
std::vector<std::unique_ptr<RawConnection>> Connect(const std::string& address,
                                                    size_t count);

// Sends questions of `mix` for `seconds`, `rate` a second on average, at random
// moments (a Poisson process), over the connections in turn; then waits for the
// last answer. REQUIRES: rate > 0.
LoadFigures RunOpenLoop(
    const std::vector<std::unique_ptr<RawConnection>>& connections,
    Workload& workload, const Mix& mix, double rate, double seconds,
    std::mt19937_64& random);

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_RELIABILITY_OPEN_LOOP_H_
