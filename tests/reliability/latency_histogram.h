// How often which latency was seen, in little memory: for quantiles.

#ifndef GEODESIC_TESTS_RELIABILITY_LATENCY_HISTOGRAM_H_
#define GEODESIC_TESTS_RELIABILITY_LATENCY_HISTOGRAM_H_

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace geodesic::client {

// Buckets grow with the latency, 64 to each doubling: a quantile is at most
// 1.6 % too large. Not thread-safe.
class LatencyHistogram {
 public:
  void Add(std::chrono::nanoseconds latency);
  // All that the other has seen.
  void Add(const LatencyHistogram& other);

  uint64_t count() const { return count_; }

  // The least latency that so large a part of all do not exceed; 0 if there is
  // none. REQUIRES: 0 < part <= 1.
  double Milliseconds(double part) const;

  // {"count", "p50_ms", "p90_ms", "p99_ms", "max_ms"}.
  nlohmann::ordered_json Summary() const;

 private:
  static constexpr size_t kPerDoubling = 64;

  std::array<uint64_t, 60 * kPerDoubling> counts_ = {};
  uint64_t count_ = 0;
  std::chrono::nanoseconds max_{0};
};

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_RELIABILITY_LATENCY_HISTOGRAM_H_
