#include "server/engine/query_engine.h"

#include <utility>

namespace geodesic::server {
namespace {

// Bounds the index: each field on disk takes some memory.
constexpr size_t kMaxFields = 100'000;

}  // namespace

absl::StatusOr<std::unique_ptr<DurableStore>> DurableStore::Open(
    const Options& options) {
  absl::StatusOr<DataFolder> folder = DataFolder::Open(options.path);
  if (!folder.ok()) return folder.status();
  std::unique_ptr<DurableStore> store(
      new DurableStore{.folder = *std::move(folder)});
  auto meshes =
      MeshFiles::Open(store->folder, options.mesh_bytes, options.warn);
  if (!meshes.ok()) return meshes.status();
  store->meshes = *std::move(meshes);
  auto fields = BlobStore::Open(store->folder, {.kind = "field",
                                                .capacity = options.field_bytes,
                                                .max_count = kMaxFields,
                                                .warn = options.warn});
  if (!fields.ok()) return fields.status();
  store->fields = *std::move(fields);
  return store;
}

QueryEngine::QueryEngine(const Limits& limits, const Clock& clock,
                         Executor& executor, StartFunction start)
    : limits_(limits),
      start_(std::move(start)),
      upload_memory_(std::make_shared<ByteBudget>("upload memory",
                                                  limits.upload_memory_bytes)),
      solver_memory_(std::make_shared<ByteBudget>("solver memory",
                                                  limits.solver_memory_bytes)),
      meshes_(limits_, clock, scheduler_, upload_memory_,
              [this](const std::string& digest) {
                fields_.EraseMesh(digest);
                searches_.landmarks().EraseMesh(digest);
                methods_.EraseMesh(digest);
              }),
      searches_(limits_, solve_options_, clock, scheduler_, solver_memory_,
                start_, meshes_),
      methods_(limits_, clock, scheduler_, solver_memory_, meshes_),
      fields_(limits_, solve_options_, clock, scheduler_, solver_memory_,
              start_, meshes_, searches_),
      solo_jobs_(clock, scheduler_, solver_memory_, limits.progress_interval),
      rows_(limits_, scheduler_, solo_jobs_, solver_memory_, meshes_, searches_,
            fields_),
      scheduler_(executor, limits.max_concurrent_jobs, limits.max_queued_jobs,
                 limits.max_queued_jobs_per_client) {}

QueryEngine::~QueryEngine() { scheduler_.StopAll(); }

void QueryEngine::Attach(std::unique_ptr<DurableStore> durable,
                         const std::string& version, Blobs* shared) {
  durable_ = std::move(durable);
  if (durable_ != nullptr) meshes_.Attach(*durable_->meshes);
  kept_.emplace(durable_ != nullptr ? durable_->fields.get() : nullptr, shared,
                version);
  fields_.Attach(kept_->fields);
  searches_.landmarks().Attach(kept_->landmarks);
  methods_.Attach(kept_->graphs);
}

absl::StatusOr<QuestionCall> QueryEngine::StartQuestion(
    QuestionRequest request) {
  absl::StatusOr<MeshHandle> mesh =
      meshes_.Get(request.mesh_digest, "mesh_digest");
  if (!mesh.ok()) return mesh.status();
  absl::StatusOr<ValidQuery> query =
      ValidQuery::Make(std::move(request.query), *(*mesh)->mesh);
  if (!query.ok()) return query.status();
  absl::StatusOr<ByteReservation> memory =
      ByteReservation::Make(solver_memory_, 0);
  if (!memory.ok()) return memory.status();
  QuestionCall call{
      .mesh = *std::move(mesh),
      .algorithm = (*query)->algorithm,
      .tolerance = (*query)->tolerance,
      .answer_memory = std::make_shared<ByteReservation>(*std::move(memory))};
  SoloJob solo{.priority = SolvePriority(request.requester.is_batch),
               .client = request.requester.client,
               .account = std::move(request.requester.account),
               .deadline = request.deadline,
               .planned_bytes = PlannedSolverBytes(*call.mesh->mesh, *query),
               .done = std::move(request.done),
               .progress = std::move(request.progress)};
  // The size of the answer is only known when the work is done.
  solo.work = [this, mesh = call.mesh, memory = call.answer_memory,
               query = *std::move(query), work = std::move(request.work)](
                  Checkpoint& checkpoint, ByteReservation) mutable {
    return work(*mesh->mesh, query,
                WithIdleThreads(solve_options_, scheduler_,
                                limits_.max_threads_per_solve),
                checkpoint, *memory);
  };
  absl::StatusOr<SoloJobs::Call> job = solo_jobs_.Start(std::move(solo));
  if (!job.ok()) return job.status();
  call.job = *std::move(job);
  return call;
}

EngineCounters QueryEngine::counters() const {
  return {fields_.counters(), meshes_.meshes_built(), meshes_.meshes_loaded(),
          meshes_.meshes_fetched(), rows_.pair_counts()};
}

}  // namespace geodesic::server
