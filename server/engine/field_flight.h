// Concurrent identical queries share one computation, a flight. Each waiter
// may leave on its own; when the last has left, the flight is called off.

#ifndef GEODESIC_SERVER_ENGINE_FIELD_FLIGHT_H_
#define GEODESIC_SERVER_ENGINE_FIELD_FLIGHT_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "server/engine/clock.h"
#include "server/engine/field_key.h"
#include "server/engine/field_request.h"
#include "server/engine/job_checkpoint.h"
#include "server/engine/scheduler.h"
#include "server/engine/settled_log.h"

namespace geodesic::server {

// Who waits for a field. Calls come from a solver's thread, one at a time, and
// must be short; they may still arrive while and just after the waiter leaves.
class FieldObserver {
 public:
  virtual ~FieldObserver() = default;

  // A later call replaces what an earlier one said.
  virtual void OnProgress(const Progress& progress) = 0;

  // The last call, at most once: the answer or why there is none.
  virtual void OnField(const absl::StatusOr<FieldAnswer>& answer) = 0;
};

struct Waiter {
  std::shared_ptr<FieldObserver> observer;
  TimePoint deadline = kNoDeadline;
  JobPriority priority = JobPriority::kSolve;
};

// Thread-safe. Observers are never called under a lock.
class FieldFlights {
 public:
  class Flight;

  // A waiter's place in a flight.
  struct Seat {
    std::shared_ptr<Flight> flight;
    uint64_t number = 0;
    // The first in its flight, who has to see to it that it takes place.
    bool is_first = false;
    // The flight's job, if it has one already, which is to be as urgent as this
    // waiter is.
    std::optional<Scheduler::JobId> job;
    // If the key asks for it: what is final already. OnProgress tells of more.
    std::shared_ptr<SettledLog> settled;
  };

  // Boards the flight to `key`; opens it when there is none.
  Seat Join(const FlightKey& key, Waiter waiter);

  // Gives the seat up. When nobody is left, the flight is closed to others and
  // its job, if it has one already, is returned for the caller to cancel.
  std::optional<Scheduler::JobId> Leave(const Seat& seat);

  // Tells which job does the work. How urgent those are who have boarded.
  JobPriority SetJob(Flight& flight, Scheduler::JobId job);

  // For the thread that does the work, and for nobody else at the same time:

  // Takes out the waiters whose deadline has come and tells them so. Returns
  // DEADLINE_EXCEEDED or CANCELLED when nobody is left.
  absl::Status Expire(Flight& flight, TimePoint now);

  void Publish(Flight& flight, const Progress& progress);

  // Ends the flight and tells everybody. Whoever asks from now on opens a new
  // one: what should be found then must be in the cache before.
  void Complete(Flight& flight, const absl::StatusOr<FieldAnswer>& answer);

  size_t size() const;
  // Waiters on all flights.
  size_t waiters() const;

 private:
  using Observers = std::vector<std::shared_ptr<FieldObserver>>;

  // REQUIRES: mutex_ held.
  void Close(Flight& flight);

  mutable std::mutex mutex_;
  // Guarded by mutex_, as the content of every flight is:
  std::map<FlightKey, std::shared_ptr<Flight>> open_;
  uint64_t next_number_ = 0;
};

// The waiters of one flight, for its checkpoint.
class FlightAudience final : public JobAudience {
 public:
  // The references outlive the audience.
  FlightAudience(FieldFlights& flights, FieldFlights::Flight& flight)
      : flights_(flights), flight_(flight) {}

  absl::Status Expire(TimePoint now) override {
    return flights_.Expire(flight_, now);
  }
  void Publish(const Progress& progress) override {
    flights_.Publish(flight_, progress);
  }

 private:
  FieldFlights& flights_;
  FieldFlights::Flight& flight_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELD_FLIGHT_H_
