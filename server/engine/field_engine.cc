#include "server/engine/field_engine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "server/engine/argument_checks.h"
#include "server/engine/guarded.h"
#include "server/engine/idle_threads.h"
#include "server/engine/job_checkpoint.h"
#include "server/engine/settled_checkpoint.h"
#include "server/engine/status_details.h"

namespace geodesic::server {
namespace {

absl::Status CheckReach(const FieldReach& reach, size_t targets) {
  if (absl::Status status = CheckRadius("max_distance", reach.radius);
      !status.ok()) {
    return status;
  }
  if (reach.LimitsTargets() &&
      (reach.targets == 0 || reach.targets > targets)) {
    return InvalidField(
        "stop_after_targets",
        absl::StrCat("stop_after_targets is ", reach.targets,
                     "; the request has ", targets, " targets"));
  }
  return absl::OkStatus();
}

// Distances at vertices are in the field itself, so the targets that the
// solver need not know of are left out: more questions are the same then.
Query WithoutVertexTargets(Query query) {
  std::erase_if(query.targets, [](const SurfacePoint& target) {
    return std::holds_alternative<VertexPoint>(target);
  });
  return query;
}

// What is kept of the solver's memory for the answer.
uint64_t SettledBytes(const FieldExtras& extras, uint64_t vertices) {
  return extras.settled_order ? SettledLog::BytesFor(vertices) : 0;
}

// The rest of the order, once the field is there.
void FinishOrder(const DistanceField& field, double radius, SettledLog& log) {
  log.Append({.settled_radius = std::min(field.settled_radius, radius),
              .distances = field.distances});
}

}  // namespace

FieldEngine::FieldEngine(const Limits& limits, const SolveOptions& options,
                         const Clock& clock, Scheduler& scheduler,
                         std::shared_ptr<ByteBudget> solver_memory,
                         StartFunction start)
    : limits_(limits),
      options_(options),
      clock_(clock),
      start_(std::move(start)),
      solver_memory_(std::move(solver_memory)),
      scheduler_(scheduler),
      fields_(limits.field_cache_bytes),
      computations_(limits.computation_store_bytes) {}

absl::StatusOr<FieldCall> FieldEngine::Compute(
    const FieldRequest& request, const MeshHandle& mesh,
    std::shared_ptr<FieldObserver> observer) {
  absl::Status status =
      ValidateAsNumbered(request.query, request.numbers, *mesh->mesh);
  if (!status.ok()) return status;
  status = CheckReach(request.reach, request.query.targets.size());
  if (!status.ok()) return status;

  FieldCall call{.mesh = mesh, .reach = request.reach};
  call.query = Canonicalize(request.query, *mesh->mesh);
  call.query.trace |= request.extras.NeedTrace();
  call.source_numbers =
      NumberCanonical(request.query, request.numbers, call.query, *mesh->mesh);
  const FlightKey key{
      .field = MakeFieldKey(mesh->digest,
                            request.reach.LimitsTargets()
                                ? call.query
                                : WithoutVertexTargets(call.query),
                            options_),
      .reach = request.reach,
      .extras = request.extras};

  const auto find_cached = [&] {
    FieldCache::Found found = fields_.Find(key.field, key.reach);
    if (found.field == nullptr) return false;
    ++queries_cached_;
    call.origin = FieldOrigin::kCached;
    // The rest takes a job.
    if (key.extras.Any()) return true;
    call.answer =
        FieldAnswer{.field = std::move(found.field),
                    .query = std::make_shared<const Query>(ToQuery(found.key)),
                    .origin = FieldOrigin::kCached};
    return true;
  };
  const bool is_kept = find_cached();
  if (is_kept && call.answer.has_value()) return call;
  if (request.must_be_kept && !is_kept &&
      (files_ == nullptr || !files_->Find(key.field, key.reach))) {
    return FieldNotKept();
  }

  const JobPriority priority = SolvePriority(request.requester.is_batch);
  call.seat =
      flights_.Join(key, {std::move(observer), request.deadline, priority});
  if (!call.seat.is_first) {
    if (call.seat.job) scheduler_.Expedite(*call.seat.job, priority);
    if (call.origin != FieldOrigin::kCached) {
      call.origin = FieldOrigin::kJoined;
      ++queries_joined_;
    }
    return call;
  }
  const std::shared_ptr<FieldFlights::Flight> flight = call.seat.flight;
  // The flight before this one may have landed after the first look.
  if (call.origin != FieldOrigin::kCached && find_cached() &&
      call.answer.has_value()) {
    flights_.Leave(call.seat);
    flights_.Complete(*flight, *call.answer);
    return call;
  }
  if (call.origin != FieldOrigin::kCached && files_ != nullptr &&
      files_->Find(key.field, key.reach)) {
    ++queries_cached_;
    call.origin = FieldOrigin::kCached;
  }
  if (call.origin != FieldOrigin::kCached &&
      computations_.Contains(key.field)) {
    call.origin = FieldOrigin::kContinued;
  }
  absl::StatusOr<Scheduler::JobId> job =
      Submit(request.requester, mesh, key, call.seat);
  if (!job.ok()) {
    flights_.Leave(call.seat);
    flights_.Complete(*flight, job.status());
    return job.status();
  }
  // Somebody in a hurry may have boarded in the meantime.
  scheduler_.Expedite(*job, flights_.SetJob(*flight, *job));
  return call;
}

absl::StatusOr<Scheduler::JobId> FieldEngine::Submit(
    const Requester& requester, const MeshHandle& mesh, const FlightKey& key,
    const FieldFlights::Seat& seat) {
  auto job = std::make_shared<FlightJob>();
  job->mesh = mesh;
  job->key = key;
  job->solver_bytes = PlannedSolverBytes(*mesh->mesh, ToQuery(key.field));
  if (absl::Status status = CheckCapacity(*job); !status.ok()) return status;
  return scheduler_.Submit(
      {.priority = SolvePriority(requester.is_batch),
       .client = requester.client,
       .reserve = [this, job] { return Provide(*job); },
       .run =
           [this, job, flight = seat.flight,
            settled = seat.settled](std::stop_token stop) {
             flights_.Complete(*flight, Guarded("answered a query", [&] {
               return Answer(*job, *flight, settled.get(), std::move(stop));
             }));
           },
       .abandon =
           [this, flight = seat.flight](const absl::Status& why) {
             flights_.Complete(*flight, why);
           }});
}

absl::Status FieldEngine::CheckCapacity(const FlightJob& job) const {
  const uint64_t vertices = job.mesh->mesh->vertex_count();
  absl::Status status = fields_.CheckCapacity(job.key.field, vertices);
  if (!status.ok()) return status;
  return solver_memory_->CheckCapacity(job.solver_bytes +
                                       SettledBytes(job.key.extras, vertices) +
                                       DerivedBytes(job.key.extras, vertices));
}

absl::Status FieldEngine::Provide(FlightJob& job) {
  const uint64_t vertices = job.mesh->mesh->vertex_count();
  auto settled = ByteReservation::Make(solver_memory_,
                                       SettledBytes(job.key.extras, vertices));
  if (!settled.ok()) return settled.status();
  auto derived = ByteReservation::Make(solver_memory_,
                                       DerivedBytes(job.key.extras, vertices));
  if (!derived.ok()) return derived.status();
  FieldCache::Found found = fields_.Find(job.key.field, job.key.reach);
  if (found.field == nullptr) {
    // The cache's room is taken, too: a field that nobody could keep while it
    // is streamed would be memory out of all bounds.
    auto room = fields_.Reserve(job.key.field, vertices);
    if (!room.ok()) return room.status();
    auto memory = ByteReservation::Make(solver_memory_, job.solver_bytes);
    if (!memory.ok()) return memory.status();
    job.room = *std::move(room);
    job.memory = *std::move(memory);
  }
  job.found = std::move(found);
  job.settled = *std::move(settled);
  job.derived = *std::move(derived);
  return absl::OkStatus();
}

absl::StatusOr<FieldAnswer> FieldEngine::Answer(FlightJob& job,
                                                FieldFlights::Flight& flight,
                                                SettledLog* settled,
                                                std::stop_token stop) {
  const FlightKey& key = job.key;
  FlightAudience audience(flights_, flight);
  if (settled != nullptr) {
    settled->Reserve(std::move(job.settled), job.mesh->mesh->vertex_count());
  }
  FieldAnswer answer{.origin = FieldOrigin::kCached};
  FieldCache::Found found = std::move(job.found);
  if (found.field == nullptr) found = LoadStored(job);
  if (found.field == nullptr) {
    absl::StatusOr<FieldHandle> field =
        Solve(job, audience, settled, std::move(stop), answer.origin);
    if (!field.ok()) return field.status();
    found = {key.field, *std::move(field)};
  }
  if (settled != nullptr) {
    FinishOrder(*found.field, key.reach.radius, *settled);
  }
  answer.field = std::move(found.field);
  answer.query = std::make_shared<const Query>(ToQuery(found.key));
  if (key.extras.NeedTrace()) {
    auto derived = Derive(job.mesh, *answer.query, answer.field, key.extras,
                          std::move(job.derived));
    if (!derived.ok()) return derived.status();
    answer.derived = *std::move(derived);
  }
  return answer;
}

FieldCache::Found FieldEngine::LoadStored(FlightJob& job) {
  if (files_ == nullptr) return {};
  const FlightKey& key = job.key;
  const Mesh& mesh = *job.mesh->mesh;
  std::optional<FieldKey> stored = files_->Find(key.field, key.reach);
  if (!stored) return {};
  const bool is_other = *stored != key.field;
  ByteReservation other_room;
  if (is_other) {
    auto taken = fields_.Reserve(*stored, mesh.vertex_count());
    if (!taken.ok()) return {};
    other_room = *std::move(taken);
  }
  absl::StatusOr<DistanceField> field = files_->Load(*stored, mesh);
  // What cannot be read is computed.
  if (!field.ok() || !Covers(*field, key.reach)) return {};
  ++fields_loaded_;
  FieldHandle handle = fields_.Insert(
      *stored, *std::move(field), std::move(is_other ? other_room : job.room));
  return {*std::move(stored), std::move(handle)};
}

absl::StatusOr<FieldHandle> FieldEngine::Solve(FlightJob& flight_job,
                                               JobAudience& audience,
                                               SettledLog* settled,
                                               std::stop_token stop,
                                               FieldOrigin& origin) {
  const MeshHandle& mesh = flight_job.mesh;
  const FlightKey& key = flight_job.key;
  ++solves_started_;
  JobCheckpoint job(audience, clock_, std::move(stop),
                    std::move(flight_job.memory), limits_.progress_interval);
  std::optional<SettledCheckpoint> ordered;
  if (settled != nullptr) {
    ordered.emplace(job, *settled, audience, key.reach.radius);
  }
  Checkpoint& checkpoint = ordered ? static_cast<Checkpoint&>(*ordered) : job;

  PausedComputation work = computations_.Take(key.field);
  origin = work.computation != nullptr ? FieldOrigin::kContinued
                                       : FieldOrigin::kSolved;
  absl::StatusOr<DistanceField> field =
      Guarded("computed a field", [&]() -> absl::StatusOr<DistanceField> {
        if (work.computation == nullptr) {
          auto started = start_(*mesh->mesh, ToQuery(key.field),
                                WithIdleThreads(options_, scheduler_,
                                                limits_.max_threads_per_solve));
          if (!started.ok()) return started.status();
          work = {mesh, *std::move(started)};
        } else {
          ++solves_continued_;
        }
        absl::Status status = work.computation->Advance(
            {.radius = key.reach.radius, .targets = key.reach.targets},
            checkpoint);
        if (!status.ok()) return status;
        return work.computation->Field();
      });
  if (!field.ok()) {
    ++solves_stopped_;
    return field.status();
  }
  ++solves_finished_;
  FieldHandle handle =
      fields_.Insert(key.field, *std::move(field), std::move(flight_job.room));
  if (writer_) writer_->Enqueue(key.field, mesh, handle);
  if (!std::isinf(handle->settled_radius)) {
    computations_.Put(key.field, std::move(work));
  }
  return handle;
}

void FieldEngine::Cancel(const FieldCall& call) {
  if (call.seat.flight == nullptr) return;
  if (const auto job = flights_.Leave(call.seat)) scheduler_.Cancel(*job);
}

void FieldEngine::EraseMesh(const std::string& digest) {
  fields_.EraseMesh(digest);
  computations_.EraseMesh(digest);
  if (files_ != nullptr) files_->EraseMesh(digest);
}

FieldCounters FieldEngine::counters() const {
  return {.solves_started = solves_started_,
          .solves_finished = solves_finished_,
          .solves_stopped = solves_stopped_,
          .solves_continued = solves_continued_,
          .queries_joined = queries_joined_,
          .queries_cached = queries_cached_,
          .fields_loaded = fields_loaded_};
}

}  // namespace geodesic::server
