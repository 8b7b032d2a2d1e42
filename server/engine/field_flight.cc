#include "server/engine/field_flight.h"

#include <algorithm>

namespace geodesic::server {

class FieldFlights::Flight {
 public:
  explicit Flight(FlightKey k) : key(std::move(k)) {
    if (key.extras.settled_order) settled = std::make_shared<SettledLog>();
  }

  const FlightKey key;
  std::shared_ptr<SettledLog> settled;
  std::map<uint64_t, Waiter> waiters;
  std::optional<Scheduler::JobId> job;
  JobPriority priority = JobPriority::kStore;  // of the most urgent waiter
  bool is_open = true;
};

FieldFlights::Seat FieldFlights::Join(const FlightKey& key, Waiter waiter) {
  std::lock_guard lock(mutex_);
  const auto [it, is_first] = open_.try_emplace(key);
  if (is_first) it->second = std::make_shared<Flight>(key);
  Flight& flight = *it->second;
  const uint64_t number = next_number_++;
  flight.priority = std::min(flight.priority, waiter.priority);
  flight.waiters.emplace(number, std::move(waiter));
  return {it->second, number, is_first, flight.job, flight.settled};
}

std::optional<Scheduler::JobId> FieldFlights::Leave(const Seat& seat) {
  std::lock_guard lock(mutex_);
  Flight& flight = *seat.flight;
  if (flight.waiters.erase(seat.number) == 0 || !flight.waiters.empty()) {
    return std::nullopt;
  }
  Close(flight);
  return flight.job;
}

JobPriority FieldFlights::SetJob(Flight& flight, Scheduler::JobId job) {
  std::lock_guard lock(mutex_);
  flight.job = job;
  return flight.priority;
}

absl::Status FieldFlights::Expire(Flight& flight, TimePoint now) {
  const absl::Status late = absl::DeadlineExceededError(
      "the deadline came before the field was computed");
  Observers expired;
  bool abandoned = false;
  {
    std::lock_guard lock(mutex_);
    for (auto it = flight.waiters.begin(); it != flight.waiters.end();) {
      if (it->second.deadline > now) {
        ++it;
        continue;
      }
      expired.push_back(std::move(it->second.observer));
      it = flight.waiters.erase(it);
    }
    abandoned = flight.waiters.empty();
    if (abandoned) Close(flight);
  }
  for (const auto& observer : expired) observer->OnField(late);
  if (!abandoned) return absl::OkStatus();
  return expired.empty() ? absl::CancelledError("nobody waits for the field")
                         : late;
}

void FieldFlights::Publish(Flight& flight, const Progress& progress) {
  Observers observers;
  {
    std::lock_guard lock(mutex_);
    for (const auto& [number, waiter] : flight.waiters) {
      observers.push_back(waiter.observer);
    }
  }
  for (const auto& observer : observers) observer->OnProgress(progress);
}

void FieldFlights::Complete(Flight& flight,
                            const absl::StatusOr<FieldAnswer>& answer) {
  std::map<uint64_t, Waiter> waiters;
  {
    std::lock_guard lock(mutex_);
    waiters.swap(flight.waiters);
    Close(flight);
  }
  for (const auto& [number, waiter] : waiters) waiter.observer->OnField(answer);
}

size_t FieldFlights::size() const {
  std::lock_guard lock(mutex_);
  return open_.size();
}

size_t FieldFlights::waiters() const {
  std::lock_guard lock(mutex_);
  size_t count = 0;
  for (const auto& [key, flight] : open_) count += flight->waiters.size();
  return count;
}

void FieldFlights::Close(Flight& flight) {
  // Another flight to the same key may have opened since this one closed.
  if (!flight.is_open) return;
  flight.is_open = false;
  open_.erase(flight.key);
}

}  // namespace geodesic::server
