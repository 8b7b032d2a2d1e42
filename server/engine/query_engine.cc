#include "server/engine/query_engine.h"

#include <utility>

namespace geodesic::server {

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
  auto fields = FieldFiles::Open(store->folder, options.field_bytes,
                                 options.version, options.warn);
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
              [this](const std::string& digest) { fields_.EraseMesh(digest); }),
      fields_(limits_, solve_options_, clock, scheduler_, solver_memory_,
              start_, meshes_),
      solo_jobs_(clock, scheduler_, solver_memory_, limits.progress_interval),
      scheduler_(executor, limits.max_concurrent_jobs, limits.max_queued_jobs,
                 limits.max_queued_jobs_per_client) {}

QueryEngine::~QueryEngine() { scheduler_.StopAll(); }

void QueryEngine::Attach(std::unique_ptr<DurableStore> durable) {
  durable_ = std::move(durable);
  meshes_.Attach(*durable_->meshes);
  fields_.Attach(*durable_->fields);
}

absl::StatusOr<QuestionCall> QueryEngine::StartQuestion(
    QuestionRequest request, std::shared_ptr<JobObserver> observer) {
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
      .answer_memory = std::make_shared<ByteReservation>(*std::move(memory))};
  SoloJob solo{.priority = SolvePriority(request.requester.is_batch),
               .client = request.requester.client,
               .deadline = request.deadline,
               .planned_bytes = PlannedSolverBytes(*call.mesh->mesh, *query),
               .done = [observer](const JobReport& report) {
                 observer->OnDone(report);
               }};
  solo.progress = [observer = std::move(observer)](const Progress& progress) {
    observer->OnProgress(progress);
  };
  // How large the answer will be is not known before it is there.
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

absl::StatusOr<MatrixCall> QueryEngine::ComputeMatrix(
    MatrixRequest request, std::shared_ptr<RowObserver> observer) {
  absl::StatusOr<MeshHandle> mesh =
      meshes_.Get(request.mesh_digest, "mesh_digest");
  if (!mesh.ok()) return mesh.status();
  absl::StatusOr<ValidQuery> valid =
      ValidQuery::Make(std::move(request.query), *(*mesh)->mesh);
  if (!valid.ok()) return valid.status();
  const ValidQuery& query = *valid;
  absl::Status status = CheckMatrix(request, query, *(*mesh)->mesh, limits_);
  if (!status.ok()) return status;
  const uint64_t rows = query->sources.size();
  MatrixCall call{.mesh = *std::move(mesh), .row_count = rows};
  call.algorithm = query.OfSource(0, *call.mesh->mesh)->algorithm;
  call.column_count = query->targets.empty() ? call.mesh->mesh->vertex_count()
                                             : query->targets.size();
  RowJobs plan{.requester = request.requester,
               .deadline = request.deadline,
               .planned_bytes = PlannedSolverBytes(*call.mesh->mesh, query),
               .row_bytes = RowBytes(*query, *call.mesh->mesh)};
  // One more than can run, so that no thread waits for the reader's thanks.
  call.rows = std::make_shared<RowPipeline>(
      solo_jobs_, std::move(plan), rows, limits_.max_concurrent_jobs + 1,
      MakeRowFunction(call.mesh, query, request, solve_options_, start_),
      std::move(observer));
  absl::StatusOr<Scheduler::Place> place =
      scheduler_.HoldPlace(request.requester.client);
  if (!place.ok()) return place.status();
  if (status = call.rows->Start(*std::move(place)); !status.ok()) return status;
  return call;
}

EngineCounters QueryEngine::counters() const {
  return {fields_.counters(), meshes_.meshes_built(), meshes_.meshes_loaded()};
}

}  // namespace geodesic::server
