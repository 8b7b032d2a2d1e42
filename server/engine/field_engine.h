// Fields: found in the cache, joined, continued or computed.

#ifndef GEODESIC_SERVER_ENGINE_FIELD_ENGINE_H_
#define GEODESIC_SERVER_ENGINE_FIELD_ENGINE_H_

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/computation.h"
#include "geodesic/query.h"
#include "geodesic/solve_options.h"
#include "server/engine/byte_budget.h"
#include "server/engine/clock.h"
#include "server/engine/computation_store.h"
#include "server/engine/field_cache.h"
#include "server/engine/field_files.h"
#include "server/engine/field_flight.h"
#include "server/engine/field_key.h"
#include "server/engine/field_request.h"
#include "server/engine/field_writer.h"
#include "server/engine/limits.h"
#include "server/engine/mesh_store.h"
#include "server/engine/scheduler.h"

namespace geodesic::server {

using StartFunction =
    std::function<absl::StatusOr<std::unique_ptr<Computation>>(
        const Mesh&, const Query&, const SolveOptions&)>;

// What a question was answered with at once.
struct FieldCall {
  FieldOrigin origin = FieldOrigin::kSolved;
  MeshHandle mesh;
  // Canonical; its targets are all that were asked for, in the same order.
  Query query;
  // The client's number of each of the query's sources.
  std::vector<uint32_t> source_numbers;
  FieldReach reach;
  // Set when origin is kCached and nothing is left to do; the observer is then
  // never called.
  std::optional<FieldAnswer> answer;
  // Otherwise: for Cancel, and the log of settled vertices, if asked for.
  FieldFlights::Seat seat;
};

// How often things have happened since the start.
struct FieldCounters {
  uint64_t solves_started = 0;  // those that went on included
  uint64_t solves_finished = 0;
  // Cancelled, late, out of memory, or failed.
  uint64_t solves_stopped = 0;
  uint64_t solves_continued = 0;
  uint64_t queries_joined = 0;
  uint64_t queries_cached = 0;
  uint64_t fields_loaded = 0;  // from disk
};

// Thread-safe. No call waits for a job.
class FieldEngine {
 public:
  // What is referred to outlives the engine, and `scheduler` has no job left
  // when it goes.
  FieldEngine(const Limits& limits, const SolveOptions& options,
              const Clock& clock, Scheduler& scheduler,
              std::shared_ptr<ByteBudget> solver_memory, StartFunction start);

  // From now on keeps fields in `files`, too, which outlives the object. Call
  // before all else.
  void Attach(FieldFiles& files) {
    files_ = &files;
    writer_.emplace(files, scheduler_);
  }

  // Starts, joins or finds the computation of a field on `mesh`.
  // Errors: INVALID_ARGUMENT; NOT_FOUND: the field must be kept already and is
  // not; RESOURCE_EXHAUSTED: the queue is full, or the memory can never be had;
  // UNAVAILABLE. `observer` is then not called. It may already be called before
  // this returns.
  absl::StatusOr<FieldCall> Compute(const FieldRequest& request,
                                    const MeshHandle& mesh,
                                    std::shared_ptr<FieldObserver> observer);

  // The caller of `call` waits no longer. When it was the last, the solver
  // stops at its next poll.
  void Cancel(const FieldCall& call);

  // Drops the fields and the paused computations of a mesh. Waits for the disk,
  // if fields are kept there.
  void EraseMesh(const std::string& digest);
  // Drops the paused computations, which pin their meshes.
  void DropComputations() { computations_.Clear(); }

  FieldCounters counters() const;
  const FieldCache& fields() const { return fields_; }
  const FieldFlights& flights() const { return flights_; }
  const ComputationStore& computations() const { return computations_; }

 private:
  // One flight's job, and what it has before it runs: the field, or the memory
  // for it.
  struct FlightJob {
    MeshHandle mesh;
    FlightKey key;
    uint64_t solver_bytes = 0;  // that the solver is planned to take

    FieldCache::Found found;
    ByteReservation room;     // of the field cache
    ByteReservation memory;   // of the solver
    ByteReservation settled;  // of the solver, too, for the settled order
    ByteReservation derived;  // likewise, for other quantities
  };

  // Errors: as Scheduler::Submit; as CheckCapacity.
  absl::StatusOr<Scheduler::JobId> Submit(const Requester& requester,
                                          const MeshHandle& mesh,
                                          const FlightKey& key,
                                          const FieldFlights::Seat& seat);
  // Whether the memory for it can ever be had. Errors: RESOURCE_EXHAUSTED.
  absl::Status CheckCapacity(const FlightJob& job) const;
  // All or nothing. Errors: as ByteBudget::Take.
  absl::Status Provide(FlightJob& job);
  // The flight's work, from the job's thread.
  absl::StatusOr<FieldAnswer> Answer(FlightJob& job,
                                     FieldFlights::Flight& flight,
                                     SettledLog* settled, std::stop_token stop);
  // A field on disk that answers the question, or nothing.
  FieldCache::Found LoadStored(FlightJob& job);
  absl::StatusOr<FieldHandle> Solve(FlightJob& job, JobAudience& audience,
                                    SettledLog* settled, std::stop_token stop,
                                    FieldOrigin& origin);

  const Limits& limits_;
  const SolveOptions options_;
  const Clock& clock_;
  const StartFunction start_;
  const std::shared_ptr<ByteBudget> solver_memory_;
  Scheduler& scheduler_;
  FieldCache fields_;
  ComputationStore computations_;
  FieldFlights flights_;
  FieldFiles* files_ = nullptr;        // null: fields are kept in memory alone
  std::optional<FieldWriter> writer_;  // of files_

  std::atomic<uint64_t> solves_started_ = 0;
  std::atomic<uint64_t> solves_finished_ = 0;
  std::atomic<uint64_t> solves_stopped_ = 0;
  std::atomic<uint64_t> solves_continued_ = 0;
  std::atomic<uint64_t> queries_joined_ = 0;
  std::atomic<uint64_t> queries_cached_ = 0;
  std::atomic<uint64_t> fields_loaded_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELD_ENGINE_H_
