// The service without its wire: resident meshes, uploads and field queries.
//
//   SteadyClock clock;
//   ThreadPool pool(limits.max_concurrent_jobs);
//   QueryEngine engine(limits, clock, pool);
//   absl::StatusOr<FieldCall> call = engine.ComputeField(request, observer);
//   ...                    // observer->OnField brings the field
//   engine.Cancel(*call);  // or nobody needs it any more

#ifndef GEODESIC_SERVER_ENGINE_QUERY_ENGINE_H_
#define GEODESIC_SERVER_ENGINE_QUERY_ENGINE_H_

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "absl/functional/any_invocable.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/computation.h"
#include "geodesic/solve_options.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/base/limits.h"
#include "server/engine/base/requester.h"
#include "server/engine/durable_store.h"
#include "server/engine/fields/field_engine.h"
#include "server/engine/fields/matrix.h"
#include "server/engine/jobs/executor.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/jobs/shared_jobs.h"
#include "server/engine/jobs/solo_job.h"
#include "server/engine/meshes/mesh_description.h"
#include "server/engine/meshes/mesh_library.h"
#include "server/engine/meshes/mesh_store.h"
#include "server/engine/meshes/mesh_upload.h"

namespace geodesic::server {

using UploadCallback = std::function<void(const absl::StatusOr<UploadResult>&)>;
using UploadJobs = SharedJobs<uint64_t, UploadResult>;  // each of its own key

struct MissingMeshes {
  std::vector<std::string> mesh_digests;
  std::vector<FileKey> files;
  struct KnownFile {
    FileKey file;
    std::string mesh_digest;
  };
  std::vector<KnownFile> known_files;
};

struct MeshPage {
  std::vector<MeshDescription> meshes;
  // Empty on the last page.
  std::string next_token;
};

// A question that is answered for one client alone.
struct QuestionRequest {
  std::string mesh_digest;
  Query query;
  TimePoint deadline = kNoDeadline;
  Requester requester;
  // Charges `answer` with what it leaves behind.
  absl::AnyInvocable<absl::Status(const Mesh&, const ValidQuery&,
                                  const SolveOptions&, Checkpoint&,
                                  ByteReservation& answer)>
      work;
};

struct QuestionCall {
  MeshHandle mesh;
  // The one that runs.
  Algorithm algorithm = kDefaultAlgorithm;
  SoloJobs::Call job;
  // What the work was given to charge; held as long as the answer is.
  std::shared_ptr<ByteReservation> answer_memory;
};

struct MatrixCall {
  MeshHandle mesh;
  std::shared_ptr<RowPipeline> rows;
  uint64_t row_count = 0;
  uint64_t column_count = 0;
  Algorithm algorithm = kDefaultAlgorithm;  // of the first row
};

// How often things have happened since the start.
struct EngineCounters : FieldCounters {
  uint64_t meshes_built = 0;
  uint64_t meshes_loaded = 0;  // from disk
};

// Thread-safe. No call waits for a job. A job is the requester's, or that of
// the `client` that a call names (see Requester). No exception leaves a job:
// bad_alloc becomes RESOURCE_EXHAUSTED, anything else INTERNAL.
class QueryEngine {
 public:
  // `clock` and `executor` outlive the engine. `start` is the seam where tests
  // hold a solver up.
  QueryEngine(const Limits& limits, const Clock& clock, Executor& executor,
              StartFunction start = &StartComputation);

  // Stops all jobs and waits for them.
  // REQUIRES: the executor runs what it has been given.
  ~QueryEngine();

  // From now on meshes and fields are kept in `durable`, too. Call before all
  // else.
  void Attach(std::unique_ptr<DurableStore> durable);

  const Limits& limits() const { return limits_; }

  // Errors: INVALID_ARGUMENT naming a malformed digest, or the number of items
  // when there are more than 1000.
  absl::StatusOr<MissingMeshes> FindMissing(
      const std::vector<std::string>& mesh_digests,
      const std::vector<FileKey>& files);

  // Errors: as MeshUpload::Start; RESOURCE_EXHAUSTED when the memory for such
  // an upload can never be had; UNAVAILABLE while shutting down.
  absl::StatusOr<std::unique_ptr<MeshUpload>> StartUpload(UploadHeader header);

  // Parses, builds and keeps the mesh in a job, which waits for its memory as
  // Job::reserve says, and calls `done` from there, once, unless the job is
  // cancelled while it waits; with a durable store, when the mesh is on the
  // disk. Calls it at once, from here, when the file is known.
  // Errors, here or in `done`: INVALID_ARGUMENT (bytes missing; a malformed
  // file; a refused mesh; another digest than expected); RESOURCE_EXHAUSTED;
  // UNAVAILABLE.
  // `built` is called from the job before, with the mesh, whether or not
  // somebody still waits; what it captured goes when the job has ended.
  absl::StatusOr<std::optional<UploadJobs::Ticket>> FinishUpload(
      std::unique_ptr<MeshUpload> upload, UploadCallback done,
      const std::string& client = {},
      std::function<void(const UploadResult&)> built = nullptr);

  // Nobody waits for the upload's mesh any longer: its job is dropped, or stops
  // soon and keeps nothing. Its callback is not called.
  void CancelUpload(const UploadJobs::Ticket& upload) {
    uploads_.Leave(upload);
  }

  // A mesh in memory, which the questions below need.
  // Errors: INVALID_ARGUMENT: malformed digest; NOT_FOUND: not resident.
  absl::StatusOr<MeshHandle> GetMesh(const std::string& digest);

  // A mesh in memory or on disk.
  // Errors: INVALID_ARGUMENT: malformed digest; NOT_FOUND: in neither.
  absl::StatusOr<MeshDescription> DescribeMesh(const std::string& digest);

  // Whether the mesh is on disk though not in memory, so that AwaitMesh helps.
  bool CanLoadMesh(const std::string& digest);

  // Brings a mesh into memory and calls `done` with it; see MeshLibrary::Await.
  absl::StatusOr<std::optional<MeshLoads::Ticket>> AwaitMesh(
      const std::string& digest, MeshCallback done,
      const std::string& client = {});
  void LeaveMesh(const MeshLoads::Ticket& ticket) { meshes_.Leave(ticket); }

  // `page_size` 0 means 100, above 1000 is taken as 1000.
  // Errors: INVALID_ARGUMENT: negative size or malformed token.
  absl::StatusOr<MeshPage> ListMeshes(int page_size, const std::string& token);

  // Drops the mesh and the fields computed on it; running jobs are left alone.
  // With a durable store, in a job, and `done` hears when the mesh is gone from
  // the disk; otherwise at once.
  // Errors, here or in `done`: as DescribeMesh; RESOURCE_EXHAUSTED (the queue
  // is full); UNAVAILABLE (shutting down; the disk cannot be written).
  absl::Status DeleteMesh(const std::string& digest,
                          std::function<void(const absl::Status&)> done,
                          const std::string& client = {});

  // Starts, joins, continues or finds the computation of a field.
  // Errors: INVALID_ARGUMENT, NOT_FOUND, RESOURCE_EXHAUSTED (more than a limit;
  // queue full), UNAVAILABLE; `observer` is then not called. It may already be
  // called before this returns.
  absl::StatusOr<FieldCall> ComputeField(
      const FieldRequest& request, std::shared_ptr<FieldObserver> observer);

  // The caller of `call` waits no longer. When it was the last, the solver
  // stops at its next poll.
  void Cancel(const FieldCall& call);

  // Does `work` on the mesh in a job of its own. The query is checked first.
  // Errors: as ComputeField.
  absl::StatusOr<QuestionCall> StartQuestion(
      QuestionRequest request, std::shared_ptr<JobObserver> observer);
  void Cancel(const QuestionCall& call);

  // Starts to compute the rows of a matrix.
  // Errors: as ComputeField.
  absl::StatusOr<MatrixCall> ComputeMatrix(
      MatrixRequest request, std::shared_ptr<RowObserver> observer);

  // From now on uploads and queries that need a job fail with UNAVAILABLE.
  void BeginDrain();
  // BeginDrain, and what waits or runs is stopped with UNAVAILABLE.
  void StopAll();
  // Waits until there is no job. False when `limit` passed first.
  bool WaitIdle(std::chrono::milliseconds limit);

  // As Scheduler::ObserveJobs.
  void ObserveJobs(const Clock& clock,
                   std::function<void(const JobTimes&)> ended) {
    scheduler_.ObserveJobs(clock, std::move(ended));
  }

  EngineCounters counters() const;
  const DurableStore* durable() const { return durable_.get(); }  // may be null
  const MeshStore& meshes() const { return meshes_.store(); }
  const MeshLoads& loads() const { return meshes_.loads(); }
  const FieldEngine& fields() const { return fields_; }
  const Scheduler& scheduler() const { return scheduler_; }
  const ByteBudget& upload_memory() const { return *upload_memory_; }
  const ByteBudget& solver_memory() const { return *solver_memory_; }

 private:
  absl::Status EraseMesh(const std::string& digest);
  // The mesh that a request names as mesh_digest.
  absl::StatusOr<MeshHandle> FindMesh(const std::string& digest);

  const Limits limits_;
  const SolveOptions solve_options_;
  const StartFunction start_;
  const std::shared_ptr<ByteBudget> upload_memory_;
  const std::shared_ptr<ByteBudget> solver_memory_;
  std::unique_ptr<DurableStore> durable_;  // may be null
  MeshLibrary meshes_;
  UploadJobs uploads_;
  std::atomic<uint64_t> next_upload_ = 0;
  FieldEngine fields_;
  SoloJobs solo_jobs_;

  std::atomic<bool> draining_ = false;

  // Last, so that no job is left when the others go.
  Scheduler scheduler_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_QUERY_ENGINE_H_
