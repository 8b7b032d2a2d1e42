#include "server/engine/fields/settled_log.h"

#include <algorithm>

namespace geodesic::server {
namespace {

// Append looks at every vertex, which is cheap once in so many windows.
constexpr uint64_t kWindowsPerVertex = 4;

}  // namespace

void SettledLog::Reserve(ByteReservation memory, size_t vertices) {
  MutexLock lock(mutex_);
  memory_ = std::move(memory);
  entries_.reserve(vertices);
}

void SettledLog::Append(const Progress& progress) {
  const std::vector<SettledVertex> settled = collector_.Collect(progress);
  MutexLock lock(mutex_);
  entries_.insert(entries_.end(), settled.begin(), settled.end());
}

size_t SettledLog::size() const {
  MutexLock lock(mutex_);
  return entries_.size();
}

std::vector<SettledVertex> SettledLog::Read(size_t begin, size_t count) const {
  MutexLock lock(mutex_);
  const size_t end = std::min(entries_.size(), begin + count);
  return {entries_.begin() + begin, entries_.begin() + end};
}

absl::Status SettledCheckpoint::Poll(const Progress& progress) {
  absl::Status status = next_.Poll(progress);
  // Before the first window not even the sources have distances.
  if (progress.windows_propagated < next_scan_ ||
      progress.settled_radius <= 0) {
    return status;
  }
  next_scan_ = progress.windows_propagated +
               kWindowsPerVertex * progress.distances.size();
  // Vertices that are final are logged even if the solver has to stop now.
  Progress within = progress;
  within.settled_radius = std::min(progress.settled_radius, radius_);
  const size_t before = log_.size();
  log_.Append(within);
  if (log_.size() > before) next_.Publish(within);
  return status;
}

}  // namespace geodesic::server
