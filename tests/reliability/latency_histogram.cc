#include "tests/reliability/latency_histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace geodesic::client {

void LatencyHistogram::Add(std::chrono::nanoseconds latency) {
  // The number's leading bit chooses the doubling, the six bits below it the
  // bucket; numbers below 128 have a bucket each.
  const auto value =
      static_cast<uint64_t>(std::max<int64_t>(0, latency.count()));
  const int shift = std::max(0, static_cast<int>(std::bit_width(value)) - 7);
  const size_t bucket =
      static_cast<size_t>(shift) * kPerDoubling + (value >> shift);
  ++counts_[std::min(bucket, counts_.size() - 1)];
  ++count_;
  max_ = std::max(max_, latency);
}

void LatencyHistogram::Add(const LatencyHistogram& other) {
  for (size_t bucket = 0; bucket < counts_.size(); ++bucket) {
    counts_[bucket] += other.counts_[bucket];
  }
  count_ += other.count_;
  max_ = std::max(max_, other.max_);
}

double LatencyHistogram::Milliseconds(double part) const {
  const auto wanted =
      static_cast<uint64_t>(std::ceil(part * static_cast<double>(count_)));
  const double max = 1e-6 * static_cast<double>(max_.count());
  uint64_t seen = 0;
  for (size_t bucket = 0; bucket < counts_.size(); ++bucket) {
    seen += counts_[bucket];
    if (seen < wanted || seen == 0) continue;
    // The bucket's end. From 128 on a doubling has only the upper 64 buckets,
    // which is why its number runs on from the one before.
    const size_t shift =
        bucket < 2 * kPerDoubling ? 0 : bucket / kPerDoubling - 1;
    const auto end = static_cast<double>(bucket - shift * kPerDoubling + 1);
    return std::min(max, 1e-6 * std::ldexp(end, static_cast<int>(shift)));
  }
  return 0;
}

nlohmann::ordered_json LatencyHistogram::Summary() const {
  return {{"count", count_},
          {"p50_ms", Milliseconds(0.5)},
          {"p90_ms", Milliseconds(0.9)},
          {"p99_ms", Milliseconds(0.99)},
          {"max_ms", Milliseconds(1)}};
}

}  // namespace geodesic::client
