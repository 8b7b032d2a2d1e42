#include "server/engine/searches/landmark_maker.h"

#include <algorithm>
#include <bit>
#include <thread>
#include <utility>

#include "geodesic/valid_query.h"
#include "server/engine/base/status_details.h"

namespace geodesic::server {
namespace {

// At most this many meshes wait; a mesh that found no place asks again.
constexpr size_t kMaxTurns = 64;

// Ends a step as soon as a thread is wanted for something else.
class IdleCheckpoint final : public Checkpoint {
 public:
  // The references outlive it. `extra_bytes` are charged to `memory` beside
  // what the solver takes.
  IdleCheckpoint(const Scheduler& scheduler, std::stop_token stop,
                 const MeshStore& meshes, const std::string& digest,
                 ByteReservation& memory, uint64_t extra_bytes)
      : scheduler_(scheduler),
        stop_(std::move(stop)),
        meshes_(meshes),
        digest_(digest),
        memory_(memory),
        extra_bytes_(extra_bytes) {}

  // Errors: ABORTED: somebody waits, go on later; CANCELLED: the landmarks are
  // of no use any more; RESOURCE_EXHAUSTED.
  absl::Status Poll(const Progress& progress) override {
    std::this_thread::yield();
    if (stop_.stop_requested() || scheduler_.is_draining()) {
      return absl::CancelledError("the server is shutting down");
    }
    if (!meshes_.Holds(digest_))
      return absl::CancelledError("the mesh is gone");
    if (scheduler_.queued() > 0) return absl::AbortedError("a job waits");
    return memory_.GrowTo(progress.solver_bytes + extra_bytes_);
  }

 private:
  const Scheduler& scheduler_;
  const std::stop_token stop_;
  const MeshStore& meshes_;
  const std::string& digest_;
  ByteReservation& memory_;
  const uint64_t extra_bytes_;
};

// The memory of a finished field's distances, beside the solver's.
uint64_t DistanceBytes(const Mesh& mesh) {
  return mesh.vertex_count() * sizeof(double);
}

}  // namespace

LandmarkMaker::LandmarkMaker(const SolveOptions& options, Scheduler& scheduler,
                             std::shared_ptr<ByteBudget> solver_memory,
                             StartFunction start, MeshLibrary& meshes)
    : options_(options),
      start_(std::move(start)),
      solver_memory_(std::move(solver_memory)),
      scheduler_(scheduler),
      meshes_(meshes) {}

LandmarksHandle LandmarkMaker::Wanted(const MeshHandle& mesh) {
  LandmarkStore& store = meshes_.landmarks();
  LandmarksHandle present = store.Find(mesh->digest);
  const bool is_enough = present != nullptr && !present->next().has_value();
  if (!is_enough && store.CanHold(*mesh->mesh)) Enqueue(mesh);
  return present;
}

void LandmarkMaker::Enqueue(const MeshHandle& mesh) {
  std::lock_guard lock(mutex_);
  const bool is_there = std::ranges::any_of(
      turns_, [&](const Turn& turn) { return turn.digest == mesh->digest; });
  if (is_there || turns_.size() >= kMaxTurns) return;
  turns_.push_back({mesh->digest, mesh});
  if (turns_.size() == 1) SubmitStep();
}

void LandmarkMaker::SubmitStep() {
  const bool is_admitted =
      scheduler_
          .Submit(
              {.priority = JobPriority::kPrepare,
               .is_continuation = true,
               .run = [this](const std::stop_token& stop) { RunStep(stop); },
               .abandon = [](const absl::Status&) {}})
          .ok();
  // The server is stopping.
  if (!is_admitted) turns_.clear();
}

void LandmarkMaker::RunStep(const std::stop_token& stop) {
  const MeshHandle mesh = [this] {
    std::lock_guard lock(mutex_);
    return turns_.front().mesh.lock();
  }();
  const absl::StatusOr<bool> goes_on =
      Guarded("made landmarks", [&] { return Step(mesh, stop); });
  const bool is_over = !goes_on.ok() || !*goes_on;
  if (is_over) work_ = Work();
  std::lock_guard lock(mutex_);
  if (is_over) turns_.pop_front();
  if (!turns_.empty()) SubmitStep();
}

absl::StatusOr<bool> LandmarkMaker::Step(const MeshHandle& mesh,
                                         const std::stop_token& stop) {
  if (mesh == nullptr) return false;
  if (scheduler_.queued() > 0) {
    // Jobs wait, and this one was started all the same: they lack memory.
    work_.field.reset();
    return true;
  }
  absl::Status status;
  if (!work_.landmarks) status = Begin(*mesh);
  if (!status.ok()) return status;
  if (!work_.landmarks->next().has_value()) {
    Publish(*mesh);
    return false;
  }
  if (!work_.field) status = StartField(mesh);
  if (!status.ok()) return status;
  Field& field = *work_.field;
  IdleCheckpoint checkpoint(scheduler_, stop, meshes_.store(), mesh->digest,
                            field.memory, DistanceBytes(*mesh->mesh));
  status = field.computation->Advance({}, checkpoint);
  if (absl::IsAborted(status)) return true;
  if (!status.ok()) return status;
  work_.landmarks->Add(*mesh->mesh, field.computation->Field().distances);
  work_.field.reset();
  ++made_;
  const bool goes_on = work_.landmarks->next().has_value();
  if (!goes_on) Store(*mesh);
  Publish(*mesh);
  return goes_on;
}

absl::Status LandmarkMaker::Begin(const ResidentMesh& mesh) {
  // Those of a turn that was broken off.
  const LandmarksHandle present = meshes_.landmarks().Find(mesh.digest);
  absl::StatusOr<ByteReservation> room =
      meshes_.landmarks().Reserve(*mesh.mesh);
  if (!room.ok()) return room.status();
  work_.room = *std::move(room);
  if (present != nullptr) {
    work_.landmarks = *present;
    return absl::OkStatus();
  }
  if (files_ != nullptr) {
    absl::StatusOr<Landmarks> stored = files_->Load(mesh.digest, *mesh.mesh);
    if (stored.ok()) {
      loaded_ += stored->count();
      work_.landmarks = *std::move(stored);
      return absl::OkStatus();
    }
  }
  work_.landmarks = Landmarks(*mesh.mesh);
  return absl::OkStatus();
}

absl::Status LandmarkMaker::StartField(const MeshHandle& mesh) {
  const absl::StatusOr<ValidQuery> query = ValidQuery::Make(
      {.sources = {{VertexPoint{*work_.landmarks->next()}}}}, *mesh->mesh);
  if (!query.ok()) return query.status();
  absl::StatusOr<ByteReservation> memory = ByteReservation::Make(
      solver_memory_,
      PlannedSolverBytes(*mesh->mesh, *query) + DistanceBytes(*mesh->mesh));
  if (!memory.ok()) return memory.status();
  auto computation = start_(*mesh->mesh, *query, options_);
  if (!computation.ok()) return computation.status();
  work_.field = Field{mesh, *std::move(memory), *std::move(computation)};
  return absl::OkStatus();
}

void LandmarkMaker::Store(const ResidentMesh& mesh) {
  if (files_ == nullptr) return;
  // A full disk does not hurt questions; uploads report it.
  (void)files_->Put(mesh.digest, *work_.landmarks);
  // A mesh that was deleted before now had no file.
  if (!meshes_.Contains(mesh.digest)) files_->Erase(mesh.digest);
}

void LandmarkMaker::EraseMesh(const std::string& digest) {
  if (files_ != nullptr) files_->Erase(digest);
}

void LandmarkMaker::Publish(const ResidentMesh& mesh) {
  LandmarkStore& store = meshes_.landmarks();
  Landmarks& landmarks = *work_.landmarks;
  if (!landmarks.next().has_value()) {
    store.Insert(mesh.digest, std::move(landmarks), std::move(work_.room));
  } else if (std::has_single_bit(landmarks.count())) {
    // A copy for questions that come meanwhile, if there is room for two.
    absl::StatusOr<ByteReservation> room = store.Reserve(*mesh.mesh);
    if (room.ok()) store.Insert(mesh.digest, landmarks, *std::move(room));
  }
  // A mesh that went before now found no landmarks to take along.
  if (!meshes_.store().Holds(mesh.digest)) store.Erase(mesh.digest);
}

}  // namespace geodesic::server
