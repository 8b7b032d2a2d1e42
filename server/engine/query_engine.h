// The service without gRPC: meshes, fields, pairs and other questions about
// them.
//
//   SteadyClock clock;
//   ThreadPool pool(Scheduler::ThreadsFor(limits.max_concurrent_jobs));
//   QueryEngine engine(limits, clock, pool);
//   auto call = engine.fields().Compute(request, observer);
//   ...                             // observer->OnField brings the field
//   engine.fields().Cancel(*call);  // or nobody needs it any more

#ifndef GEODESIC_SERVER_ENGINE_QUERY_ENGINE_H_
#define GEODESIC_SERVER_ENGINE_QUERY_ENGINE_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "absl/functional/any_invocable.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/computation.h"
#include "geodesic/query.h"
#include "geodesic/solve_options.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/base/limits.h"
#include "server/engine/fields/field_engine.h"
#include "server/engine/fields/field_files.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/jobs/solo_job.h"
#include "server/engine/jobs/start_function.h"
#include "server/engine/jobs/thread_pool.h"
#include "server/engine/meshes/mesh_files.h"
#include "server/engine/meshes/mesh_library.h"
#include "server/engine/methods/graph_files.h"
#include "server/engine/methods/method_engine.h"
#include "server/engine/rows/row_engine.h"
#include "server/engine/searches/landmark_files.h"
#include "server/engine/searches/search_engine.h"
#include "server/store/blob_store.h"
#include "server/store/blob_tiers.h"
#include "server/store/blobs.h"
#include "server/store/data_folder.h"

namespace geodesic::server {

// What a server keeps in its data folder: meshes and fields, each within a
// budget.
struct DurableStore {
  struct Options {
    std::string path;
    // Bytes of disk.
    uint64_t mesh_bytes = 0;
    uint64_t field_bytes = 0;
    // Is called with a line for people about each damaged file.
    std::function<void(const std::string& line)> warn;
  };

  // Locks the folder and reads what is in it.
  // Errors: as DataFolder::Open and BlobStore::Open.
  static absl::StatusOr<std::unique_ptr<DurableStore>> Open(
      const Options& options);

  DataFolder folder;
  std::unique_ptr<MeshFiles> meshes;
  std::unique_ptr<BlobStore> fields;  // and landmarks and graphs
};

// A question that is answered for one client alone.
struct QuestionRequest {
  std::string mesh_digest;
  Query query;
  TimePoint deadline = kNoDeadline;
  Requester requester;
  // Answers the question, and charges `answer` with the memory it keeps.
  absl::AnyInvocable<absl::Status(const Mesh&, const ValidQuery&,
                                  const SolveOptions&, Checkpoint&,
                                  ByteReservation& answer)>
      work;
  // See SoloJob. They may still be called during Cancel and just after it.
  std::function<void(const JobReport&)> done;
  std::function<void(const Progress&)> progress;
};

struct QuestionCall {
  MeshHandle mesh;
  // The one that runs.
  Algorithm algorithm = kDefaultAlgorithm;
  // That the answer holds within; 0: exact.
  double tolerance = 0;
  SoloJobs::Call job;
  // The memory that the work charged; held as long as the answer is.
  std::shared_ptr<ByteReservation> answer_memory;
};

// How often things have happened since the start.
struct EngineCounters : FieldCounters {
  uint64_t meshes_built = 0;
  uint64_t meshes_loaded = 0;   // from disk
  uint64_t meshes_fetched = 0;  // from the shared tier
  PairCounts pairs;
};

// Thread-safe. No call waits for a job. No exception leaves a job: bad_alloc
// becomes RESOURCE_EXHAUSTED, anything else INTERNAL.
class QueryEngine {
 public:
  // `clock` and `executor` outlive the engine. `start` is the seam where tests
  // hold a solver up.
  QueryEngine(const Limits& limits, const Clock& clock, Executor& executor,
              StartFunction start = &StartComputation);

  // Stops all jobs and waits for them.
  // REQUIRES: the executor runs what it has been given.
  ~QueryEngine();

  // From now on meshes are kept in `durable`, and fields and what is prepared
  // of meshes there and in `shared`. Either may be null; `shared` outlives the
  // engine. For `version`, the program's, see FieldFiles. Call at most once,
  // before any other method.
  void Attach(std::unique_ptr<DurableStore> durable, const std::string& version,
              Blobs* shared = nullptr);

  MeshLibrary& meshes() { return meshes_; }
  SearchEngine& searches() { return searches_; }
  MethodEngine& methods() { return methods_; }
  FieldEngine& fields() { return fields_; }
  RowEngine& rows() { return rows_; }
  // After its BeginDrain, uploads and queries that need a job fail with
  // UNAVAILABLE.
  Scheduler& scheduler() { return scheduler_; }

  // Does `work` on the mesh in a job of its own. The query is checked first.
  // Errors: as FieldEngine::Compute.
  absl::StatusOr<QuestionCall> StartQuestion(QuestionRequest request);
  void Cancel(const QuestionCall& call) { solo_jobs_.Cancel(call.job); }

  const Limits& limits() const { return limits_; }
  EngineCounters counters() const;
  const DurableStore* durable() const { return durable_.get(); }  // may be null
  const MeshLibrary& meshes() const { return meshes_; }
  const SearchEngine& searches() const { return searches_; }
  const MethodEngine& methods() const { return methods_; }
  const FieldEngine& fields() const { return fields_; }
  const Scheduler& scheduler() const { return scheduler_; }
  const ByteBudget& upload_memory() const { return *upload_memory_; }
  const ByteBudget& solver_memory() const { return *solver_memory_; }

 private:
  // What can be made again, by its kinds.
  struct KeptResults {
    KeptResults(BlobStore* disk, Blobs* shared, const std::string& version)
        : blobs(disk, shared),
          fields(blobs, version),
          landmarks(blobs, version),
          graphs(blobs, version) {}

    BlobTiers blobs;
    FieldFiles fields;
    LandmarkFiles landmarks;
    GraphFiles graphs;
  };

  const Limits limits_;
  const SolveOptions solve_options_;
  const StartFunction start_;
  const std::shared_ptr<ByteBudget> upload_memory_;
  const std::shared_ptr<ByteBudget> solver_memory_;
  std::unique_ptr<DurableStore> durable_;  // may be null
  std::optional<KeptResults> kept_;
  MeshLibrary meshes_;
  SearchEngine searches_;
  MethodEngine methods_;
  FieldEngine fields_;
  SoloJobs solo_jobs_;
  RowEngine rows_;

  // Last, so no job is left when the other members are destroyed.
  Scheduler scheduler_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_QUERY_ENGINE_H_
