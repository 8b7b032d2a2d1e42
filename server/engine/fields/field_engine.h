// Finds fields in the cache, joins running computations or starts new ones.
// Paths to few targets are searched for, unless a field is there.

#ifndef GEODESIC_SERVER_ENGINE_FIELDS_FIELD_ENGINE_H_
#define GEODESIC_SERVER_ENGINE_FIELDS_FIELD_ENGINE_H_

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
#include "geodesic/log_map.h"
#include "geodesic/path.h"
#include "geodesic/query.h"
#include "geodesic/solve_options.h"
#include "geodesic/valid_query.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/base/limits.h"
#include "server/engine/fields/field_cache.h"
#include "server/engine/fields/field_files.h"
#include "server/engine/fields/settled_log.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/jobs/shared_jobs.h"
#include "server/engine/jobs/start_function.h"
#include "server/engine/meshes/mesh_library.h"
#include "server/engine/meshes/mesh_store.h"
#include "server/engine/meshes/method_store.h"
#include "server/engine/searches/search_engine.h"
#include "server/locks/mutex.h"

namespace geodesic::server {

struct FieldRequest {
  std::string mesh_digest;
  Query query;
  // If set, the field is computed by this approximate method. The algorithm of
  // the query plays no part then.
  std::optional<MethodHandle> method = {};
  FieldReach reach;
  FieldExtras extras;
  TimePoint deadline = kNoDeadline;
  Requester requester;
  // Fails unless the field is kept already.
  bool must_be_kept = false;
};

enum class FieldOrigin {
  kComputed,
  kJoined,  // another request had started the computation
  kCached,
};

// The quantities that were asked for and are made from a finished, traced
// field. Sources are numbered as in the field's query.
struct DerivedQuantities {
  ByteReservation memory;
  // Pinned for the tracer.
  MeshHandle mesh;
  FieldHandle field;

  // Per vertex:
  std::vector<uint32_t> nearest_sources;
  std::vector<Point> gradients;
  LogMap log_map;

  std::optional<PathTracer> paths;
  // Or, if they were searched for, one per target of the query.
  std::vector<GeodesicPath> found_paths;
};

// Handles pin what they point to. The field may hold more than was asked for;
// after a search it holds distances of targets alone.
struct FieldAnswer {
  FieldHandle field;
  // Null if no quantity was asked for.
  std::shared_ptr<const DerivedQuantities> derived;
  FieldOrigin origin = FieldOrigin::kComputed;
};

// Is told about a field. Calls come from a solver's thread, one at a time, and
// must be short. They may still arrive during Cancel and just after it.
class FieldObserver {
 public:
  virtual ~FieldObserver() = default;

  // Each call replaces the one before.
  virtual void OnProgress(const Progress& progress) = 0;

  // The last call, at most once: the answer or why there is none.
  virtual void OnField(const absl::StatusOr<FieldAnswer>& answer) = 0;
};

// Equal questions that are asked at the same time share one computation.
using FieldJobs = SharedJobs<FieldJobKey, FieldAnswer, SettledLog>;

// What Compute returns at once.
struct FieldCall {
  FieldOrigin origin = FieldOrigin::kComputed;
  MeshHandle mesh;
  // Sorted; its targets are all that were asked for, in the same order.
  ValidQuery query;
  // For each source of the query, its number in the request.
  std::vector<uint32_t> source_numbers;
  FieldReach reach;
  // Set if the field is approximate.
  std::optional<MethodChoice> method = {};
  // Set if origin is kCached and no job is needed. The observer is then not
  // called.
  std::optional<FieldAnswer> answer;
  // Otherwise: the ticket for Cancel and, if asked for, the log of final
  // vertices. OnProgress is called when the log has grown.
  FieldJobs::Ticket ticket;
  std::shared_ptr<SettledLog> settled;
};

// Reads the targets of a question from its answer, in order. The field has
// targets of its own: all of them, or only those that are not vertices.
struct TargetReader {
  struct Target {
    double distance;
    bool is_own;
    uint32_t number;  // of the field's own target, or else of the vertex
  };
  // REQUIRES: `next` is below the number of targets.
  Target Next(const FieldCall& call, const FieldAnswer& answer);

  uint64_t next = 0;
  uint32_t next_own = 0;
};

// How often things have happened since the start.
struct FieldCounters {
  uint64_t solves_started = 0;
  uint64_t solves_finished = 0;
  // Cancelled, late, out of memory, or failed.
  uint64_t solves_stopped = 0;
  uint64_t queries_joined = 0;
  uint64_t queries_cached = 0;
  uint64_t fields_loaded = 0;  // from disk and from the shared tier
};

// Thread-safe. No call waits for a job.
class FieldEngine {
 public:
  // A field is dropped when its mesh is gone from `meshes`. REQUIRES: the
  // references outlive the engine, and `scheduler` has no job left when it is
  // destroyed.
  FieldEngine(const Limits& limits, const SolveOptions& options,
              const Clock& clock, Scheduler& scheduler,
              std::shared_ptr<ByteBudget> solver_memory, StartFunction start,
              MeshLibrary& meshes, SearchEngine& searches);

  // From now on also keeps fields in `files`, which outlives the object. Call
  // before any other method.
  void Attach(FieldFiles& files) {
    files_ = &files;
    if (files.has_disk()) writer_.emplace(files, scheduler_, meshes_);
  }

  // Starts, joins or finds the computation of a field.
  // Errors: INVALID_ARGUMENT; NOT_FOUND: the mesh is not resident, or the field
  // must be kept already and is not; RESOURCE_EXHAUSTED: a limit is exceeded,
  // the queue is full, or the memory can never be had; UNAVAILABLE. `observer`
  // is not called after an error; it may be called before this returns.
  absl::StatusOr<FieldCall> Compute(const FieldRequest& request,
                                    std::shared_ptr<FieldObserver> observer);

  // The whole exact field of one source, computed by the default algorithm, if
  // it is in the cache; otherwise null. Distances at vertices alone are sure to
  // be in it. REQUIRES: the source is on the mesh.
  FieldHandle FindWhole(const ResidentMesh& mesh, const SurfacePoint& source);

  // Ends the wait for `call`. If it was the last, the solver stops soon.
  void Cancel(const FieldCall& call) { jobs_.Leave(call.ticket); }

  // Drops the fields of a mesh. Waits for the disk, if fields are kept there.
  void EraseMesh(const std::string& digest);

  FieldCounters counters() const;
  const FieldCache& cache() const { return fields_; }
  const FieldJobs& jobs() const { return jobs_; }

 private:
  // One job. Before it runs it has the field, or the memory to compute it.
  struct FieldJob {
    MeshHandle mesh;
    FieldJobKey key;
    std::optional<MethodHandle> method;       // for an approximate field
    std::shared_ptr<SettledLog> settled_log;  // null: nobody asks for it
    uint64_t solver_bytes = 0;  // that the solver is planned to take
    std::optional<LandmarksHandle> search;  // if the targets are searched for

    // Whether the next run reads the field from the disk.
    bool is_on_disk = false;

    std::optional<FieldCache::Found> found;
    ByteReservation room;     // of the field cache
    ByteReservation memory;   // of the solver
    ByteReservation settled;  // of the solver, too, for the settled order
    ByteReservation derived;  // of the solver, too, for other quantities
  };

  void Count(uint64_t FieldCounters::*event);
  // Whether the job's memory can ever be had. Errors: RESOURCE_EXHAUSTED.
  absl::Status CheckCapacity(const FieldJob& job) const;
  // Finds the field or takes memory for it. Errors: as ByteBudget::Take.
  absl::Status Provide(FieldJob& job);
  // If the result is empty, call Provide and this again.
  absl::StatusOr<std::optional<FieldAnswer>> Answer(FieldJob& job,
                                                    JobCheckpoint& checkpoint);
  // Puts a field into the cache.
  FieldHandle Keep(const FieldKey& key, DistanceField field,
                   ByteReservation room);
  // A field on the disk, or in the shared tier, that answers the question; or
  // nothing.
  std::optional<FieldCache::Found> LoadFromDisk(FieldJob& job);
  std::optional<FieldCache::Found> LoadShared(FieldJob& job);
  // The field of this key from there. Errors: as FieldFiles::Load; NOT_FOUND if
  // it does not reach far enough; RESOURCE_EXHAUSTED.
  absl::StatusOr<FieldCache::Found> Load(FieldJob& job, const FieldKey& stored);
  absl::StatusOr<FieldAnswer> Search(FieldJob& job, JobCheckpoint& checkpoint);
  absl::StatusOr<FieldHandle> Solve(FieldJob& job, JobCheckpoint& checkpoint);
  absl::StatusOr<DistanceField> SolveExactly(const FieldJob& job,
                                             Checkpoint& checkpoint);

  const Limits& limits_;
  const SolveOptions options_;
  const StartFunction start_;
  const std::shared_ptr<ByteBudget> solver_memory_;
  Scheduler& scheduler_;
  MeshLibrary& meshes_;
  SearchEngine& searches_;
  FieldCache fields_;
  FieldJobs jobs_;
  FieldFiles* files_ = nullptr;        // null: fields are kept in memory alone
  std::optional<FieldWriter> writer_;  // of files_, if there is a disk

  mutable Mutex counters_mutex_;
  FieldCounters counters_ ABSL_GUARDED_BY(counters_mutex_);
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELDS_FIELD_ENGINE_H_
