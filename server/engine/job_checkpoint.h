// What a running solver meets at each poll: its waiters, their deadlines, a
// request to stop, and the memory budget that all solvers share.

#ifndef GEODESIC_SERVER_ENGINE_JOB_CHECKPOINT_H_
#define GEODESIC_SERVER_ENGINE_JOB_CHECKPOINT_H_

#include <memory>
#include <stop_token>

#include "absl/status/status.h"
#include "geodesic/checkpoint.h"
#include "server/engine/byte_budget.h"
#include "server/engine/clock.h"
#include "server/engine/field_flight.h"

namespace geodesic::server {

// Belongs to one job and its thread.
class JobCheckpoint final : public Checkpoint {
 public:
  // The references outlive the checkpoint. `memory` holds what the job has of
  // its budget so far.
  JobCheckpoint(FieldFlights& flights, FieldFlights::Flight& flight,
                const Clock& clock, std::stop_token stop,
                ByteReservation memory, Duration progress_interval);

  // Errors: CANCELLED or DEADLINE_EXCEEDED when nobody waits any more;
  // UNAVAILABLE when the job was asked to stop though somebody waits;
  // RESOURCE_EXHAUSTED when the solver has outgrown the memory budget.
  absl::Status Poll(const Progress& progress) override;

 private:
  FieldFlights& flights_;
  FieldFlights::Flight& flight_;
  const Clock& clock_;
  const std::stop_token stop_;
  const Duration progress_interval_;
  ByteReservation memory_;
  TimePoint next_progress_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOB_CHECKPOINT_H_
