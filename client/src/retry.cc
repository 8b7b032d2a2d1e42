#include "retry.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <random>
#include <utility>

#include "geodesic_client/errors.h"

namespace geodesic::client {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr Seconds kFirstDelay(0.2);
constexpr Seconds kLongestDelay(10);

}  // namespace

bool WaitToRetry(const absl::Status& status, int attempts,
                 std::stop_token stop) {
  const std::optional<Seconds> suggested = RetryDelay(status);
  if (attempts >= kMaxAttempts) return false;
  if (!absl::IsUnavailable(status) && !suggested.has_value()) return false;
  Seconds delay = suggested.value_or(kFirstDelay * (1 << (attempts - 1)));
  // Clients that were refused together should not come back together.
  thread_local std::minstd_rand random{std::random_device{}()};
  delay *= std::uniform_real_distribution<>(1, 1.3)(random);
  delay = std::min(delay, kLongestDelay);
  std::mutex mutex;
  std::condition_variable_any stopped;
  std::unique_lock lock(mutex);
  stopped.wait_for(lock, stop, delay, [] { return false; });
  return !stop.stop_requested();
}

}  // namespace geodesic::client
