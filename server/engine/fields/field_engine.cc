#include "server/engine/fields/field_engine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "geodesic/field_quantities.h"
#include "geodesic_types/field_path.h"
#include "server/engine/base/argument_checks.h"
#include "server/engine/base/status_details.h"

namespace geodesic::server {
namespace {

absl::Status CheckReach(const FieldReach& reach, size_t targets) {
  if (absl::Status status = CheckRadius(reach.radius); !status.ok()) {
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

// The request's query, with a trace if its quantities need one.
// Errors: as ValidQuery::Make.
absl::StatusOr<ValidQuery> MakeValid(const FieldRequest& request,
                                     const Mesh& mesh) {
  Query query = request.query;
  // The protocol calls the only source of a log map by another name.
  if (request.extras.log_map && query.sources.size() == 1) {
    const auto* point = std::get_if<SurfacePoint>(&query.sources[0].place);
    absl::Status status =
        point == nullptr ? absl::OkStatus() : Validate(*point, mesh, "source");
    if (!status.ok()) return status;
  }
  query.trace |= request.extras.NeedTrace();
  return ValidQuery::Make(std::move(query), mesh);
}

// What no approximate field has. Errors: INVALID_ARGUMENT.
absl::Status CheckApproximate(const FieldRequest& request) {
  const auto refuse = [&](const char* field, const char* what) {
    return InvalidField(field, absl::StrCat(field, ": ",
                                            std::string(ApproximateMethodName(
                                                request.method->choice.method)),
                                            " is approximate and ", what));
  };
  if (request.extras.settled_order) {
    return refuse("progressive",
                  "settles no distance before the others; ask for the field");
  }
  if (request.extras.NeedTrace()) {
    return refuse("quantities", "keeps no paths; ask an exact algorithm");
  }
  if (request.extras.certified_errors) {
    return refuse("quantities", "certifies nothing; ask an exact algorithm");
  }
  if (request.reach.LimitsTargets()) {
    return refuse("stop_after_targets",
                  "computes whole fields; leave the limit out");
  }
  return CheckPlaces(request.method->choice.method, request.query);
}

// What no field within a tolerance has. Errors: INVALID_ARGUMENT.
absl::Status CheckWithinTolerance(const FieldExtras& extras) {
  const auto refuse = [&](const char* field, const char* what) {
    return InvalidField(
        field, absl::StrCat(field, ": a field within a tolerance ", what,
                            "; leave the tolerance out"));
  };
  if (extras.settled_order) {
    return refuse("progressive", "has final distances at its end alone");
  }
  if (extras.NeedTrace()) return refuse("quantities", "keeps no paths");
  return absl::OkStatus();
}

// The part of the solver's memory that the settled order takes.
uint64_t SettledBytes(const FieldExtras& extras, uint64_t vertices) {
  return extras.settled_order ? SettledLog::BytesFor(vertices) : 0;
}

// Appends the rest of the order once the field is computed.
void FinishOrder(const DistanceField& field, double radius, SettledLog& log) {
  log.Append({.settled_radius = std::min(field.settled_radius, radius),
              .distances = field.distances});
}

// A whole field. That it is approximate is told by its key alone, from which
// every answer takes it.
absl::StatusOr<DistanceField> SolveApproximately(const MethodHandle& method,
                                                 const ValidQuery& query,
                                                 Checkpoint& checkpoint) {
  absl::StatusOr<ApproximateField> field =
      method.method->Distances(query, checkpoint);
  if (!field.ok()) return field.status();
  return DistanceField{.distances = std::move(field->distances),
                       .statistics = {.solve_seconds = field->solve_seconds}};
}

// Moves the value out, or passes the error on.
template <typename T>
absl::Status Assign(absl::StatusOr<T> from, T& to) {
  if (!from.ok()) return from.status();
  to = *std::move(from);
  return absl::OkStatus();
}

// Whether the question is about paths to its targets and nothing else, and can
// be answered by searches that are directed at them.
bool MayBeSearched(const FieldJobKey& key) {
  return TargetSearch::IsDirected(key.field.query->algorithm) &&
         key.extras == FieldExtras{.paths = true} &&
         key.reach.targets == key.field.query->targets.size() &&
         std::isinf(key.reach.radius);
}

// The memory that Derive must be given.
uint64_t DerivedBytes(const FieldExtras& extras, uint64_t vertices) {
  if (!extras.NeedTrace()) return 0;
  uint64_t per_vertex = 0;
  if (extras.nearest_sources) per_vertex += sizeof(uint32_t);
  if (extras.gradients) per_vertex += sizeof(Point);
  if (extras.log_map) per_vertex += sizeof(LogMap::coordinates[0]);
  return vertices * per_vertex + sizeof(DerivedQuantities);
}

// Log maps end at `radius`. O(V), plus the edges that the paths of a log map
// cross.
// REQUIRES: `field` was solved for `query`, with a trace; extras.NeedTrace().
// Errors: INVALID_ARGUMENT for a log map around a vertex that allows none; the
// checkpoint's.
absl::StatusOr<std::shared_ptr<const DerivedQuantities>> Derive(
    const MeshHandle& mesh, const ValidQuery& query, const FieldHandle& field,
    const FieldExtras& extras, double radius, ByteReservation memory,
    Checkpoint& checkpoint) {
  auto derived = std::make_shared<DerivedQuantities>();
  derived->memory = std::move(memory);
  derived->mesh = mesh;
  derived->field = field;
  absl::Status status;
  if (extras.nearest_sources) {
    status = Assign(NearestSources(*mesh->mesh, query, *field, checkpoint),
                    derived->nearest_sources);
  }
  if (status.ok() && extras.gradients) {
    status = Assign(Gradients(*mesh->mesh, query, *field, checkpoint),
                    derived->gradients);
  }
  if (status.ok() && extras.log_map) {
    status =
        Assign(ComputeLogMap(*mesh->mesh, query, *field, radius, checkpoint),
               derived->log_map);
    if (absl::IsInvalidArgument(status))
      status = WithFieldPath(status, "source");
  }
  if (status.ok() && extras.paths) {
    absl::StatusOr<PathTracer> paths =
        PathTracer::Create(*mesh->mesh, query, *field);
    if (!paths.ok()) return paths.status();
    derived->paths = *std::move(paths);
  }
  if (!status.ok()) return status;
  return derived;
}

}  // namespace

TargetReader::Target TargetReader::Next(const FieldCall& call,
                                        const FieldAnswer& answer) {
  const std::vector<SurfacePoint>& targets = call.query->targets;
  const std::vector<double>& own = answer.field->target_distances;
  const auto* vertex = std::get_if<VertexPoint>(&targets[next++]);
  if (vertex == nullptr || own.size() == targets.size()) {
    return {own[next_own], true, next_own++};
  }
  return {answer.field->distances[vertex->vertex], false, vertex->vertex};
}

FieldEngine::FieldEngine(const Limits& limits, const SolveOptions& options,
                         const Clock& clock, Scheduler& scheduler,
                         std::shared_ptr<ByteBudget> solver_memory,
                         StartFunction start, MeshLibrary& meshes,
                         SearchEngine& searches)
    : limits_(limits),
      options_(options),
      start_(std::move(start)),
      solver_memory_(std::move(solver_memory)),
      scheduler_(scheduler),
      meshes_(meshes),
      searches_(searches),
      fields_(limits.field_cache_bytes),
      jobs_(scheduler, clock, limits.progress_interval) {}

absl::StatusOr<FieldCall> FieldEngine::Compute(
    const FieldRequest& request, std::shared_ptr<FieldObserver> observer) {
  absl::StatusOr<MeshHandle> resident =
      meshes_.Get(request.mesh_digest, "mesh_digest");
  if (!resident.ok()) return resident.status();
  // A method knows the mesh that it was made of, not an equal one.
  const MeshHandle mesh =
      request.method.has_value() ? request.method->mesh : *resident;
  const absl::StatusOr<ValidQuery> query = MakeValid(request, *mesh->mesh);
  if (!query.ok()) return query.status();
  absl::Status status = CheckReach(request.reach, request.query.targets.size());
  if (status.ok() && request.method.has_value()) {
    status = CheckApproximate(request);
  }
  if (status.ok() && request.query.tolerance > 0) {
    status = CheckWithinTolerance(request.extras);
  }
  if (!status.ok()) return status;

  SortedQuery sorted = query->Sorted();
  FieldCall call{.mesh = mesh,
                 .query = std::move(sorted.query),
                 .source_numbers = std::move(sorted.numbers),
                 .reach = request.reach};
  if (request.method.has_value()) call.method = request.method->choice;
  FieldExtras extras = request.extras;
  extras.certified_errors = false;
  // The field itself holds distances at vertices. Vertex targets that the
  // solver does not need are left out, so more questions are equal.
  const FieldJobKey key{
      .field = {.mesh_digest = mesh->digest,
                .query = request.reach.LimitsTargets()
                             ? call.query
                             : call.query.WithoutVertexTargets(),
                .bucket_width = options_.bucket_width,
                .max_batch = options_.max_batch,
                .method = call.method},
      .reach = request.reach,
      .extras = extras};

  const bool is_cached = [&] {
    std::optional<FieldCache::Found> found = fields_.Find(key.field, key.reach);
    if (found && !key.extras.Any()) {
      call.answer = FieldAnswer{.field = std::move(found->field),
                                .origin = FieldOrigin::kCached};
    }
    return found.has_value();
  }();
  if (call.answer.has_value()) {
    Count(&FieldCounters::queries_cached);
    call.origin = FieldOrigin::kCached;
    return call;
  }
  status = CheckPrepared(request.method);
  if (!status.ok()) return status;
  const bool is_on_disk = !is_cached && files_ != nullptr &&
                          files_->Find(key.field, key.reach).has_value();
  const bool is_kept = is_cached || is_on_disk;
  if (request.must_be_kept && !is_kept) return AnswerNotKept();

  auto job = std::make_shared<FieldJob>(
      FieldJob{.mesh = mesh,
               .key = key,
               .method = request.method,
               .settled_log = key.extras.settled_order
                                  ? std::make_shared<SettledLog>(mesh->mesh)
                                  : nullptr,
               .solver_bytes = PlannedSolverBytes(*mesh->mesh, key.field.query),
               .is_on_disk = is_on_disk});
  if (!is_kept && MayBeSearched(key)) {
    const ValidQuery& searched = key.field.query;
    LandmarksHandle landmarks = searches_.landmarks().Present(*mesh);
    if (key.reach.targets <
        FieldInSearches(searched->algorithm, landmarks.get())) {
      job->search = std::move(landmarks);
      job->solver_bytes = TargetSearch::PlannedBytes(*mesh->mesh, searched);
    }
  }
  if (status = CheckCapacity(*job); !status.ok()) return status;
  Waiter<FieldAnswer> waiter{
      .done =
          [observer](const absl::StatusOr<FieldAnswer>& answer) {
            observer->OnField(answer);
          },
      .progress =
          [observer = std::move(observer)](const Progress& progress) {
            observer->OnProgress(progress);
          },
      .deadline = request.deadline,
      .account = request.requester.account};
  const JobPriority priority = SolvePriority(request.requester.is_batch);
  absl::StatusOr<FieldJobs::Ticket> ticket =
      jobs_.Join(key, std::move(waiter), priority, [&] {
        return SharedWork<FieldAnswer, SettledLog>{
            .client = request.requester.client,
            .reserve = [this, job] { return Provide(*job); },
            .run = [this, job](JobCheckpoint& checkpoint)
                -> absl::StatusOr<std::optional<FieldAnswer>> {
              return Answer(*job, checkpoint);
            },
            .waits_for_disk = [job] { return job->is_on_disk; },
            .shared = job->settled_log};
      });
  if (!ticket.ok()) return ticket.status();
  call.ticket = *std::move(ticket);
  call.settled = call.ticket.shared;
  // A cached field needs a job only for its extras.
  if (is_cached || (is_kept && call.ticket.is_first)) {
    Count(&FieldCounters::queries_cached);
    call.origin = FieldOrigin::kCached;
  } else if (!call.ticket.is_first) {
    Count(&FieldCounters::queries_joined);
    call.origin = FieldOrigin::kJoined;
  }
  return call;
}

FieldHandle FieldEngine::FindWhole(const ResidentMesh& mesh,
                                   const SurfacePoint& source) {
  if (fields_.size() == 0) return nullptr;
  absl::StatusOr<ValidQuery> query =
      ValidQuery::Make({.sources = {{source}}}, *mesh.mesh);
  if (!query.ok()) return nullptr;
  std::optional<FieldCache::Found> found =
      fields_.Find({.mesh_digest = mesh.digest,
                    .query = *std::move(query),
                    .bucket_width = options_.bucket_width,
                    .max_batch = options_.max_batch},
                   {});
  return found ? std::move(found->field) : nullptr;
}

absl::Status FieldEngine::CheckCapacity(const FieldJob& job) const {
  const uint64_t vertices = job.mesh->mesh->vertex_count();
  absl::Status status = fields_.CheckCapacity(job.key.field, vertices);
  if (!status.ok()) return status;
  return solver_memory_->CheckCapacity(job.solver_bytes +
                                       SettledBytes(job.key.extras, vertices) +
                                       DerivedBytes(job.key.extras, vertices));
}

absl::Status FieldEngine::Provide(FieldJob& job) {
  if (job.found) return absl::OkStatus();
  // What was taken to read it from the disk.
  job.room = {};
  job.memory = {};
  job.settled = {};
  job.derived = {};
  const uint64_t vertices = job.mesh->mesh->vertex_count();
  auto settled = ByteReservation::Make(solver_memory_,
                                       SettledBytes(job.key.extras, vertices));
  if (!settled.ok()) return settled.status();
  auto derived = ByteReservation::Make(solver_memory_,
                                       DerivedBytes(job.key.extras, vertices));
  if (!derived.ok()) return derived.status();
  std::optional<FieldCache::Found> found =
      fields_.Find(job.key.field, job.key.reach);
  if (!found && job.search) {
    auto memory = ByteReservation::Make(solver_memory_, job.solver_bytes);
    if (!memory.ok()) return memory.status();
    job.memory = *std::move(memory);
  } else if (!found) {
    // Room in the cache is taken, too, because a field that is streamed without
    // it would be memory that no budget counts.
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

absl::StatusOr<std::optional<FieldAnswer>> FieldEngine::Answer(
    FieldJob& job, JobCheckpoint& checkpoint) {
  const FieldJobKey& key = job.key;
  if (std::exchange(job.is_on_disk, false)) {
    if (!job.found) job.found = LoadFromDisk(job);
    const bool is_all =
        job.found && job.settled_log == nullptr && !job.key.extras.NeedTrace();
    // The rest is computed, on a thread for that.
    if (!is_all) return std::nullopt;
  }
  SettledLog* const settled = job.settled_log.get();
  if (settled != nullptr) {
    settled->Reserve(std::move(job.settled), job.mesh->mesh->vertex_count());
  }
  FieldAnswer answer{.origin = FieldOrigin::kCached};
  std::optional<FieldCache::Found> found = std::move(job.found);
  if (!found && job.search) return Search(job, checkpoint);
  if (!found) found = LoadShared(job);
  if (!found) {
    absl::StatusOr<FieldHandle> field = Solve(job, checkpoint);
    if (!field.ok()) return field.status();
    answer.origin = FieldOrigin::kComputed;
    found = {key.field, *std::move(field)};
  }
  if (settled != nullptr) {
    FinishOrder(*found->field, key.reach.radius, *settled);
  }
  answer.field = std::move(found->field);
  if (key.extras.NeedTrace()) {
    auto derived = Derive(job.mesh, found->key.query, answer.field, key.extras,
                          key.reach.radius, std::move(job.derived), checkpoint);
    if (!derived.ok()) return derived.status();
    answer.derived = *std::move(derived);
  }
  return answer;
}

FieldHandle FieldEngine::Keep(const FieldKey& key, DistanceField field,
                              ByteReservation room) {
  FieldHandle kept = fields_.Insert(key, std::move(field), std::move(room));
  // A deletion of the mesh before now found no field to erase; a later one
  // will.
  if (!meshes_.Contains(key.mesh_digest)) fields_.EraseMesh(key.mesh_digest);
  return kept;
}

std::optional<FieldCache::Found> FieldEngine::LoadFromDisk(FieldJob& job) {
  const auto stored = files_->Find(job.key.field, job.key.reach);
  if (!stored) return std::nullopt;
  absl::StatusOr<FieldCache::Found> loaded = Load(job, *stored);
  // A field that cannot be read is computed again.
  if (!loaded.ok()) return std::nullopt;
  return *std::move(loaded);
}

std::optional<FieldCache::Found> FieldEngine::LoadShared(FieldJob& job) {
  std::optional<FieldCache::Found> found;
  if (files_ == nullptr || !files_->has_shared()) return found;
  VisitAnsweringKeys(job.key.field, [&](const FieldKey& stored) {
    absl::StatusOr<FieldCache::Found> loaded = Load(job, stored);
    // A tier that does not answer is not asked for the next best field.
    if (!loaded.ok()) return absl::IsUnavailable(loaded.status());
    found = *std::move(loaded);
    return true;
  });
  // When it was asked for, nobody knew.
  if (found) Count(&FieldCounters::queries_cached);
  return found;
}

absl::StatusOr<FieldCache::Found> FieldEngine::Load(FieldJob& job,
                                                    const FieldKey& stored) {
  const Mesh& mesh = *job.mesh->mesh;
  const bool is_other = stored != job.key.field;
  ByteReservation other_room;
  if (is_other) {
    auto taken = fields_.Reserve(stored, mesh.vertex_count());
    if (!taken.ok()) return taken.status();
    other_room = *std::move(taken);
  }
  absl::StatusOr<FieldFiles::Stored> loaded =
      files_->Load(stored, job.key.reach, mesh);
  if (!loaded.ok()) return loaded.status();
  if (!Covers(loaded->field, job.key.reach)) {
    return absl::NotFoundError("the field ends before its targets");
  }
  Count(&FieldCounters::fields_loaded);
  FieldHandle handle = Keep(stored, std::move(loaded->field),
                            std::move(is_other ? other_room : job.room));
  if (loaded->from == BlobTier::kShared && writer_) {
    writer_->Enqueue(stored, job.mesh, handle);
  }
  return FieldCache::Found{stored, std::move(handle)};
}

absl::StatusOr<FieldAnswer> FieldEngine::Search(FieldJob& job,
                                                JobCheckpoint& checkpoint) {
  Count(&FieldCounters::solves_started);
  checkpoint.Hold(std::move(job.memory));
  absl::StatusOr<TargetDistances> found = Guarded("searched for targets", [&] {
    return SearchMeans(searches_, job.mesh)
        .Search(job.key.field.query, job.search->get(), checkpoint);
  });
  absl::Status status = found.status();
  if (status.ok()) {
    status = job.derived.GrowTo(job.derived.bytes() + BytesOf(found->paths));
  }
  if (!status.ok()) {
    Count(&FieldCounters::solves_stopped);
    return status;
  }
  Count(&FieldCounters::solves_finished);
  auto derived = std::make_shared<DerivedQuantities>();
  derived->memory = std::move(job.derived);
  derived->mesh = job.mesh;
  derived->found_paths = std::move(found->paths);
  derived->field = std::make_shared<const DistanceField>(
      DistanceField{.target_distances = std::move(found->distances),
                    .algorithm = job.key.field.query->algorithm,
                    .statistics = found->statistics});
  return FieldAnswer{.field = derived->field, .derived = derived};
}

absl::StatusOr<FieldHandle> FieldEngine::Solve(FieldJob& job,
                                               JobCheckpoint& job_checkpoint) {
  const MeshHandle& mesh = job.mesh;
  const FieldJobKey& key = job.key;
  Count(&FieldCounters::solves_started);
  job_checkpoint.Hold(std::move(job.memory));
  std::optional<SettledCheckpoint> ordered;
  if (job.settled_log != nullptr) {
    ordered.emplace(job_checkpoint, *job.settled_log, key.reach.radius);
  }
  Checkpoint& checkpoint =
      ordered ? static_cast<Checkpoint&>(*ordered) : job_checkpoint;

  absl::StatusOr<DistanceField> field = Guarded("computed a field", [&] {
    return job.method.has_value()
               ? SolveApproximately(*job.method, key.field.query, checkpoint)
               : SolveExactly(job, checkpoint);
  });
  if (!field.ok()) {
    Count(&FieldCounters::solves_stopped);
    return field.status();
  }
  Count(&FieldCounters::solves_finished);
  FieldHandle handle = Keep(key.field, *std::move(field), std::move(job.room));
  if (files_ != nullptr) {
    // What cannot be shared is no fault of the answer.
    (void)Guarded("shared a field", [&] {
      files_->Share(key.field, *mesh->mesh, *handle);
      return absl::OkStatus();
    });
  }
  if (writer_) writer_->Enqueue(key.field, mesh, handle);
  return handle;
}

absl::StatusOr<DistanceField> FieldEngine::SolveExactly(
    const FieldJob& job, Checkpoint& checkpoint) {
  const FieldJobKey& key = job.key;
  auto computation = start_(
      *job.mesh->mesh, key.field.query,
      WithIdleThreads(options_, scheduler_, limits_.max_threads_per_solve));
  if (!computation.ok()) return computation.status();
  absl::Status status =
      (*computation)
          ->Advance({.radius = key.reach.radius, .targets = key.reach.targets},
                    checkpoint);
  if (!status.ok()) return status;
  return (*computation)->Field();
}

void FieldEngine::EraseMesh(const std::string& digest) {
  fields_.EraseMesh(digest);
  if (files_ != nullptr) files_->EraseMesh(digest);
}

void FieldEngine::Count(uint64_t FieldCounters::*event) {
  MutexLock lock(counters_mutex_);
  ++(counters_.*event);
}

FieldCounters FieldEngine::counters() const {
  MutexLock lock(counters_mutex_);
  return counters_;
}

}  // namespace geodesic::server
