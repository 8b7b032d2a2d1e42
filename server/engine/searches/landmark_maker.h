// Makes landmarks of meshes in time that nobody needs.
//
//   LandmarksHandle landmarks = maker.Present(*mesh);  // those of now, or null
//   ...
//   maker.Want(mesh);                                  // for the next question
//
// A step computes the field of one landmark. While the scheduler is busy, and
// shortly after, a step works for a tenth of the time, so that questions which
// come all the time get landmarks at last. A turn ends within milliseconds when
// a job lacks memory; the next question begins another. One mesh has its turn
// at a time.

#ifndef GEODESIC_SERVER_ENGINE_SEARCHES_LANDMARK_MAKER_H_
#define GEODESIC_SERVER_ENGINE_SEARCHES_LANDMARK_MAKER_H_

#include <atomic>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/landmarks.h"
#include "geodesic/solve_options.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/jobs/start_function.h"
#include "server/engine/meshes/landmark_store.h"
#include "server/engine/meshes/mesh_library.h"
#include "server/engine/searches/landmark_files.h"
#include "server/locks/mutex.h"

namespace geodesic::server {

// Thread-safe. No call waits for a job.
class LandmarkMaker {
 public:
  // REQUIRES: the references outlive the object, and `scheduler` has no job
  // left when it is destroyed.
  LandmarkMaker(const SolveOptions& options, const Clock& clock,
                Scheduler& scheduler, std::shared_ptr<ByteBudget> solver_memory,
                StartFunction start, MeshLibrary& meshes);

  // From now on also keeps landmarks in `files`, which outlives the object.
  // Call before any other method.
  void Attach(LandmarkFiles& files) { files_ = &files; }

  // Those there are, perhaps null.
  LandmarksHandle Present(const ResidentMesh& mesh) const;

  // Says that a question about the mesh was answered that is faster with
  // landmarks. If more would help, they are made later. Does not pin the mesh
  // for that.
  void Want(const MeshHandle& mesh);

  // Makes what is missing of `count` landmarks, or none if there is no room for
  // them, on the calling thread: for a question that is long enough to pay for
  // them. Takes Landmarks::PlannedMakingBytes. False: first the disk is looked
  // at, on a thread of its own; call again later. Errors: the checkpoint's.
  absl::StatusOr<bool> MakeNow(const MeshHandle& mesh, uint32_t count,
                               Checkpoint& checkpoint);

  // Drops what the disk keeps of a mesh that is gone. Waits for the disk.
  void EraseMesh(const std::string& digest);

  // Landmarks since the start: computed, and read from disk or
  // from the shared tier.
  uint64_t made() const { return made_; }
  uint64_t loaded() const { return loaded_; }

 private:
  struct Turn {
    std::string digest;
    std::weak_ptr<const ResidentMesh> mesh;
  };
  // What has been made of the mesh whose turn it is.
  struct Work {
    ByteReservation room;  // of the landmark memory
    std::optional<Landmarks> landmarks;
    bool is_stored = false;  // on the disk
  };

  void Enqueue(const MeshHandle& mesh);
  // REQUIRES: turns_ is not empty.
  void SubmitStep() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  void RunStep(const std::stop_token& stop);

  // Called by the job alone. Whether there is more to do. Errors: the landmarks
  // cannot be made now.
  absl::StatusOr<bool> Step(const MeshHandle& mesh,
                            const std::stop_token& stop);
  // Takes those there are, in memory or, if it `may_read`, on disk, or begins
  // with none. Errors: there is no room.
  absl::StatusOr<Work> Begin(const ResidentMesh& mesh, bool may_read);
  // Whether the disk was looked at for landmarks of the mesh and had none; has
  // it done if it was not.
  bool HaveLooked(const MeshHandle& mesh);
  // Publishes landmarks that the disk has; false if it has none. Errors: as
  // Begin.
  absl::StatusOr<bool> Load(const MeshHandle& mesh);
  // Computes the next landmark. When their number has doubled, questions get a
  // copy; when they are complete, the disk. Errors: the checkpoint's.
  absl::Status AddNext(const ResidentMesh& mesh, Checkpoint& checkpoint,
                       Landmarks& landmarks);
  // If there is room for two.
  void ShowCopy(const ResidentMesh& mesh, const Landmarks& landmarks);
  void Publish(const ResidentMesh& mesh, Work work);
  void Store(const std::string& digest);

  const SolveOptions options_;
  const Clock& clock_;
  const StartFunction start_;
  const std::shared_ptr<ByteBudget> solver_memory_;
  Scheduler& scheduler_;
  MeshLibrary& meshes_;
  LandmarkFiles* files_ = nullptr;  // null: they are kept in memory alone
  std::atomic<uint64_t> made_ = 0;
  std::atomic<uint64_t> loaded_ = 0;

  Mutex mutex_;
  // The meshes that wait; while there are any, a job works on the first.
  std::deque<Turn> turns_ ABSL_GUARDED_BY(mutex_);
  // The meshes that the disk is looked at for, and whether that is over.
  std::map<std::string, bool> looked_ ABSL_GUARDED_BY(mutex_);

  Work work_;  // the job's
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_SEARCHES_LANDMARK_MAKER_H_
