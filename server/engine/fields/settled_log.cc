#include "server/engine/fields/settled_log.h"

#include <algorithm>

namespace geodesic::server {

void SettledLog::Reserve(ByteReservation memory, size_t vertices) {
  std::lock_guard lock(mutex_);
  memory_ = std::move(memory);
  entries_.reserve(vertices);
}

void SettledLog::Append(const Progress& progress) {
  const std::vector<SettledVertex> settled = collector_.Collect(progress);
  std::lock_guard lock(mutex_);
  entries_.insert(entries_.end(), settled.begin(), settled.end());
}

size_t SettledLog::size() const {
  std::lock_guard lock(mutex_);
  return entries_.size();
}

std::vector<SettledVertex> SettledLog::Read(size_t begin, size_t count) const {
  std::lock_guard lock(mutex_);
  const size_t end = std::min(entries_.size(), begin + count);
  return {entries_.begin() + begin, entries_.begin() + end};
}

}  // namespace geodesic::server
