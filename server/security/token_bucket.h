// A rate limit that lets bursts through.

#ifndef GEODESIC_SERVER_SECURITY_TOKEN_BUCKET_H_
#define GEODESIC_SERVER_SECURITY_TOKEN_BUCKET_H_

#include <algorithm>
#include <chrono>
#include <cmath>

#include "server/engine/base/clock.h"

namespace geodesic::server {

// Holds at most `burst` and refills at `rate` a second. Not thread-safe.
class TokenBucket {
 public:
  // Full. REQUIRES: rate > 0, burst >= 1.
  TokenBucket(double rate, double burst, TimePoint now)
      : rate_(rate), burst_(burst), level_(burst), time_(now) {}

  // Takes one out; or how long until there will be one.
  Duration Take(TimePoint now) {
    // An unlimited rate over no time at all would be no number.
    if (std::isinf(rate_)) return Duration::zero();
    const std::chrono::duration<double> passed = now - time_;
    level_ = std::min(burst_, level_ + rate_ * passed.count());
    time_ = now;
    if (level_ >= 1) {
      level_ -= 1;
      return Duration::zero();
    }
    return std::chrono::ceil<std::chrono::milliseconds>(
        std::chrono::duration<double>((1 - level_) / rate_));
  }

 private:
  const double rate_;
  const double burst_;
  double level_;
  TimePoint time_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SECURITY_TOKEN_BUCKET_H_
