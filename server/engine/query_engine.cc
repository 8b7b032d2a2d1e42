#include "server/engine/query_engine.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "digest/sha256.h"
#include "geodesic/field_path.h"
#include "server/engine/base/argument_checks.h"
#include "server/engine/base/guarded.h"
#include "server/engine/base/status_details.h"
#include "server/engine/jobs/idle_threads.h"
#include "server/engine/meshes/mesh_build.h"

namespace geodesic::server {
namespace {

constexpr size_t kMaxDigestsPerRequest = 1000;
constexpr int kDefaultPageSize = 100;
constexpr int kMaxPageSize = 1000;

}  // namespace

QueryEngine::QueryEngine(const Limits& limits, const Clock& clock,
                         Executor& executor, StartFunction start)
    : limits_(limits),
      start_(std::move(start)),
      upload_memory_(std::make_shared<ByteBudget>("upload memory",
                                                  limits.upload_memory_bytes)),
      solver_memory_(std::make_shared<ByteBudget>("solver memory",
                                                  limits.solver_memory_bytes)),
      meshes_(limits, clock, scheduler_, upload_memory_),
      uploads_(scheduler_, clock, limits.progress_interval),
      fields_(limits_, solve_options_, clock, scheduler_, solver_memory_,
              start_,
              [this](const std::string& digest) {
                return meshes_.Contains(digest);
              }),
      solo_jobs_(clock, scheduler_, solver_memory_, limits.progress_interval),
      scheduler_(executor, limits.max_concurrent_jobs, limits.max_queued_jobs,
                 limits.max_queued_jobs_per_client) {}

QueryEngine::~QueryEngine() { StopAll(); }

void QueryEngine::Attach(std::unique_ptr<DurableStore> durable) {
  durable_ = std::move(durable);
  meshes_.Attach(durable_->meshes(), [this](const std::string& digest) {
    fields_.EraseMesh(digest);
  });
  fields_.Attach(durable_->fields());
}

absl::StatusOr<MissingMeshes> QueryEngine::FindMissing(
    const std::vector<std::string>& mesh_digests,
    const std::vector<FileKey>& files) {
  if (mesh_digests.size() + files.size() > kMaxDigestsPerRequest) {
    return InvalidField(
        "mesh_digests",
        absl::StrCat("mesh_digests and files have ",
                     mesh_digests.size() + files.size(),
                     " items together; at most ", kMaxDigestsPerRequest,
                     " are answered at once"));
  }
  MissingMeshes missing;
  for (size_t i = 0; i < mesh_digests.size(); ++i) {
    absl::Status status =
        CheckDigest(absl::StrCat("mesh_digests[", i, "]"), mesh_digests[i]);
    if (!status.ok()) return status;
    // Marks the mesh as used, so that it outlives the client's next step.
    if (!meshes_.Contains(mesh_digests[i])) {
      missing.mesh_digests.push_back(mesh_digests[i]);
    }
  }
  for (size_t i = 0; i < files.size(); ++i) {
    absl::Status status =
        CheckDigest(absl::StrCat("files[", i, "].sha256"), files[i].sha256);
    if (!status.ok()) return status;
    if (const auto digest = meshes_.FindFile(files[i])) {
      missing.known_files.push_back({files[i], *digest});
    } else {
      missing.files.push_back(files[i]);
    }
  }
  return missing;
}

absl::StatusOr<std::unique_ptr<MeshUpload>> QueryEngine::StartUpload(
    UploadHeader header) {
  if (draining_) return ShuttingDown();
  absl::StatusOr<std::unique_ptr<MeshUpload>> upload =
      MeshUpload::Start(std::move(header), limits_, upload_memory_);
  if (!upload.ok()) return upload;
  absl::Status fits = meshes_.CheckCapacity((*upload)->header());
  if (!fits.ok()) return fits;
  return upload;
}

absl::StatusOr<std::optional<UploadJobs::Ticket>> QueryEngine::FinishUpload(
    std::unique_ptr<MeshUpload> upload, UploadCallback done,
    const std::string& client, std::function<void(const UploadResult&)> built) {
  if (absl::Status status = upload->Finish(); !status.ok()) return status;
  if (std::optional<UploadResult> known = meshes_.FindUploaded(*upload)) {
    upload.reset();
    built = nullptr;  // the client's next request may come before the return
    done(*std::move(known));
    return std::nullopt;
  }
  auto build = std::make_shared<MeshBuild>(meshes_, std::move(upload));
  absl::StatusOr<UploadJobs::Ticket> ticket = uploads_.Join(
      next_upload_++, {.done = std::move(done)}, JobPriority::kBuild, [&] {
        return SharedWork<UploadResult>{
            .priority = JobPriority::kBuild,
            .client = client,
            .reserve = [build] { return build->Reserve(); },
            .run =
                [build, built = std::move(built)](JobCheckpoint& checkpoint) {
                  auto result = build->Run(checkpoint);
                  if (result.ok() && result->has_value() && built)
                    built(**result);
                  return result;
                }};
      });
  if (!ticket.ok()) return ticket.status();
  return *std::move(ticket);
}

absl::StatusOr<MeshHandle> QueryEngine::GetMesh(const std::string& digest) {
  if (absl::Status status = CheckDigest("digest", digest); !status.ok()) {
    return status;
  }
  MeshHandle mesh = meshes_.FindResident(digest);
  if (mesh == nullptr) return NotResident(digest);
  return mesh;
}

absl::StatusOr<MeshDescription> QueryEngine::DescribeMesh(
    const std::string& digest) {
  if (absl::Status status = CheckDigest("digest", digest); !status.ok()) {
    return status;
  }
  std::optional<MeshDescription> mesh = meshes_.Describe(digest);
  if (!mesh) return NotResident(digest);
  return *std::move(mesh);
}

bool QueryEngine::CanLoadMesh(const std::string& digest) {
  return meshes_.is_durable() && meshes_.Contains(digest);
}

absl::StatusOr<std::optional<MeshLoads::Ticket>> QueryEngine::AwaitMesh(
    const std::string& digest, MeshCallback done, const std::string& client) {
  return meshes_.Await(digest, std::move(done), client);
}

absl::StatusOr<MeshPage> QueryEngine::ListMeshes(int page_size,
                                                 const std::string& token) {
  if (page_size < 0) {
    return InvalidField("page_size", absl::StrCat("page_size is ", page_size,
                                                  "; it must not be negative"));
  }
  // A token is the last digest of the page before.
  if (!token.empty() && !IsSha256Hex(token)) {
    return InvalidField("page_token",
                        "page_token is none that this server gave out");
  }
  const size_t count =
      page_size == 0 ? kDefaultPageSize : std::min(page_size, kMaxPageSize);
  MeshPage page;
  page.meshes = meshes_.List(token, count + 1);
  if (page.meshes.size() > count) {
    page.meshes.pop_back();
    page.next_token = page.meshes.back().digest;
  }
  return page;
}

absl::Status QueryEngine::DeleteMesh(
    const std::string& digest, std::function<void(const absl::Status&)> done,
    const std::string& client) {
  if (absl::Status status = CheckDigest("digest", digest); !status.ok()) {
    return status;
  }
  if (!meshes_.is_durable()) {
    done(EraseMesh(digest));
    return absl::OkStatus();
  }
  Job job{.priority = JobPriority::kBuild, .client = client, .abandon = done};
  job.run = [this, digest, done = std::move(done)](const std::stop_token&) {
    done(Guarded("deleted a mesh", [&] { return EraseMesh(digest); }));
  };
  return scheduler_.Submit(std::move(job)).status();
}

absl::Status QueryEngine::EraseMesh(const std::string& digest) {
  absl::Status status = meshes_.Erase(digest);
  if (status.ok() || absl::IsNotFound(status)) fields_.EraseMesh(digest);
  return status;
}

absl::StatusOr<FieldCall> QueryEngine::ComputeField(
    const FieldRequest& request, std::shared_ptr<FieldObserver> observer) {
  absl::StatusOr<MeshHandle> mesh = FindMesh(request.mesh_digest);
  if (!mesh.ok()) return mesh.status();
  return fields_.Compute(request, *std::move(mesh), std::move(observer));
}

void QueryEngine::Cancel(const FieldCall& call) { fields_.Cancel(call); }

absl::StatusOr<QuestionCall> QueryEngine::StartQuestion(
    QuestionRequest request, std::shared_ptr<JobObserver> observer) {
  absl::StatusOr<MeshHandle> mesh = FindMesh(request.mesh_digest);
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
               .planned_bytes = PlannedSolverBytes(*call.mesh->mesh, *query)};
  // How large the answer will be is not known before it is there.
  solo.work = [this, mesh = call.mesh, memory = call.answer_memory,
               query = *std::move(query), work = std::move(request.work)](
                  Checkpoint& checkpoint, ByteReservation) mutable {
    return work(*mesh->mesh, query,
                WithIdleThreads(solve_options_, scheduler_,
                                limits_.max_threads_per_solve),
                checkpoint, *memory);
  };
  absl::StatusOr<SoloJobs::Call> job =
      solo_jobs_.Start(std::move(solo), std::move(observer));
  if (!job.ok()) return job.status();
  call.job = *std::move(job);
  return call;
}

void QueryEngine::Cancel(const QuestionCall& call) {
  solo_jobs_.Cancel(call.job);
}

absl::StatusOr<MatrixCall> QueryEngine::ComputeMatrix(
    MatrixRequest request, std::shared_ptr<RowObserver> observer) {
  absl::StatusOr<MeshHandle> mesh = FindMesh(request.mesh_digest);
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
  if (status = call.rows->Start(); !status.ok()) return status;
  return call;
}

absl::StatusOr<MeshHandle> QueryEngine::FindMesh(const std::string& digest) {
  if (absl::Status status = CheckDigest("mesh_digest", digest); !status.ok()) {
    return status;
  }
  MeshHandle mesh = meshes_.FindResident(digest);
  if (mesh == nullptr) return NotResident(digest);
  return mesh;
}

void QueryEngine::BeginDrain() {
  draining_ = true;
  scheduler_.BeginDrain();
}

void QueryEngine::StopAll() {
  draining_ = true;
  scheduler_.StopAll();
}

bool QueryEngine::WaitIdle(std::chrono::milliseconds limit) {
  return scheduler_.WaitIdle(limit);
}

EngineCounters QueryEngine::counters() const {
  return {fields_.counters(), meshes_.meshes_built(), meshes_.meshes_loaded()};
}

}  // namespace geodesic::server
