// The engine reads time only through this interface.

#ifndef GEODESIC_SERVER_ENGINE_BASE_CLOCK_H_
#define GEODESIC_SERVER_ENGINE_BASE_CLOCK_H_

#include <chrono>

namespace geodesic::server {

using TimePoint = std::chrono::steady_clock::time_point;
using Duration = std::chrono::steady_clock::duration;

// A deadline that never comes.
inline constexpr TimePoint kNoDeadline = TimePoint::max();

// Implementations are thread-safe; Now() never decreases.
class Clock {
 public:
  virtual ~Clock() = default;
  virtual TimePoint Now() const = 0;
};

class SteadyClock final : public Clock {
 public:
  TimePoint Now() const override { return std::chrono::steady_clock::now(); }
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_BASE_CLOCK_H_
