#include "server/engine/searches/landmark_maker.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <thread>
#include <utility>

#include "geodesic/valid_query.h"
#include "server/engine/base/status_details.h"

namespace geodesic::server {
namespace {

// At most this many meshes wait; a mesh that found no place asks again.
constexpr size_t kMaxTurns = 64;
// So many are remembered for which the disk had none.
constexpr size_t kMaxLooked = 1024;

// Questions that come one after the other are not told apart from one that
// goes on: a path that follows a cursor is asked for some 30 times a second.
constexpr std::chrono::milliseconds kQuiet{100};
// Of the time that it worked, until it goes on though there is no quiet.
constexpr int kRest = 9;
// Between two looks whether there is.
constexpr std::chrono::milliseconds kNap{1};

// Has a step rest while there are questions, and ends it as soon as its memory
// is wanted for something else.
class CourteousCheckpoint final : public Checkpoint {
 public:
  // The references outlive it. `extra_bytes` are charged to `memory` beside
  // what the solver takes.
  CourteousCheckpoint(const Clock& clock, const Scheduler& scheduler,
                      std::stop_token stop, const MeshStore& meshes,
                      const std::string& digest, ByteReservation& memory,
                      uint64_t extra_bytes)
      : clock_(clock),
        scheduler_(scheduler),
        stop_(std::move(stop)),
        meshes_(meshes),
        digest_(digest),
        memory_(memory),
        extra_bytes_(extra_bytes),
        resumed_(clock.Now()) {}

  // Errors: CANCELLED: the landmarks are of no use any more;
  // RESOURCE_EXHAUSTED.
  absl::Status Poll(const Progress& progress) override {
    absl::Status status = Check(progress);
    TimePoint now = clock_.Now();
    const TimePoint rested = now + kRest * (now - resumed_);
    while (status.ok() && !IsQuiet(now) && now < rested) {
      std::this_thread::sleep_for(kNap);
      status = Check(progress);
      now = clock_.Now();
    }
    resumed_ = now;
    return status;
  }

 private:
  absl::Status Check(const Progress& progress) {
    if (stop_.stop_requested() || scheduler_.is_draining()) {
      return absl::CancelledError("the server is shutting down");
    }
    if (!meshes_.Holds(digest_))
      return absl::CancelledError("the mesh is gone");
    if (scheduler_.lacks_memory()) {
      return absl::ResourceExhaustedError("a job waits for memory");
    }
    return memory_.GrowTo(progress.solver_bytes + extra_bytes_);
  }

  bool IsQuiet(TimePoint now) {
    if (scheduler_.is_busy()) quiet_ = now + kQuiet;
    return now >= quiet_;
  }

  const Clock& clock_;
  const Scheduler& scheduler_;
  const std::stop_token stop_;
  const MeshStore& meshes_;
  const std::string& digest_;
  ByteReservation& memory_;
  const uint64_t extra_bytes_;
  TimePoint resumed_;
  TimePoint quiet_ = TimePoint::min();  // from when on, if nobody asks anew
};

bool HasEnough(const LandmarksHandle& landmarks, uint32_t count) {
  return landmarks != nullptr && landmarks->HasEnough(count);
}

// The memory of a finished field's distances, beside the solver's.
uint64_t DistanceBytes(const Mesh& mesh) {
  return mesh.vertex_count() * sizeof(double);
}

}  // namespace

LandmarkMaker::LandmarkMaker(const SolveOptions& options, const Clock& clock,
                             Scheduler& scheduler,
                             std::shared_ptr<ByteBudget> solver_memory,
                             StartFunction start, MeshLibrary& meshes)
    : options_(options),
      clock_(clock),
      start_(std::move(start)),
      solver_memory_(std::move(solver_memory)),
      scheduler_(scheduler),
      meshes_(meshes) {}

LandmarksHandle LandmarkMaker::Present(const ResidentMesh& mesh) const {
  return meshes_.landmarks().Find(mesh.digest);
}

void LandmarkMaker::Want(const MeshHandle& mesh) {
  if (!HasEnough(Present(*mesh), Landmarks::kMost) &&
      meshes_.landmarks().CanHold(*mesh->mesh)) {
    Enqueue(mesh);
  }
}

void LandmarkMaker::Enqueue(const MeshHandle& mesh) {
  MutexLock lock(mutex_);
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
    MutexLock lock(mutex_);
    return turns_.front().mesh.lock();
  }();
  const absl::StatusOr<bool> goes_on =
      Guarded("made landmarks", [&] { return Step(mesh, stop); });
  const bool is_over = !goes_on.ok() || !*goes_on;
  if (is_over) work_ = Work();
  MutexLock lock(mutex_);
  if (is_over) turns_.pop_front();
  if (!turns_.empty()) SubmitStep();
}

absl::StatusOr<bool> LandmarkMaker::Step(const MeshHandle& mesh,
                                         const std::stop_token& stop) {
  if (mesh == nullptr) return false;
  if (!work_.landmarks) {
    absl::StatusOr<Work> begun = Begin(*mesh, /*may_read=*/true);
    if (!begun.ok()) return begun.status();
    work_ = *std::move(begun);
  }
  Landmarks& landmarks = *work_.landmarks;
  if (!landmarks.HasEnough(Landmarks::kMost)) {
    absl::StatusOr<ByteReservation> memory = ByteReservation::Make(
        solver_memory_, Landmarks::PlannedMakingBytes(*mesh->mesh));
    if (!memory.ok()) return memory.status();
    CourteousCheckpoint checkpoint(clock_, scheduler_, stop, meshes_.store(),
                                   mesh->digest, *memory,
                                   DistanceBytes(*mesh->mesh));
    absl::Status status = AddNext(*mesh, checkpoint, landmarks);
    if (!status.ok()) return status;
  }
  if (!landmarks.HasEnough(Landmarks::kMost)) return true;
  Publish(*mesh, std::exchange(work_, {}));
  return false;
}

absl::StatusOr<bool> LandmarkMaker::MakeNow(const MeshHandle& mesh,
                                            uint32_t count,
                                            Checkpoint& checkpoint) {
  if (HasEnough(Present(*mesh), count)) return true;
  if (files_ != nullptr && !HaveLooked(mesh)) return false;
  absl::StatusOr<Work> work = Begin(*mesh, /*may_read=*/false);
  // Questions are answered without them.
  if (!work.ok()) return true;
  while (!work->landmarks->HasEnough(count)) {
    absl::Status status = AddNext(*mesh, checkpoint, *work->landmarks);
    if (!status.ok()) return status;
  }
  Publish(*mesh, *std::move(work));
  MutexLock lock(mutex_);
  looked_.erase(mesh->digest);
  return true;
}

bool LandmarkMaker::HaveLooked(const MeshHandle& mesh) {
  {
    MutexLock lock(mutex_);
    if (looked_.size() >= kMaxLooked) {
      std::erase_if(looked_, [](const auto& look) { return look.second; });
    }
    const auto [look, is_new] = looked_.try_emplace(mesh->digest, false);
    if (!is_new) return look->second;
  }
  scheduler_.Store([this, digest = mesh->digest, mesh = std::weak_ptr(mesh)] {
    const bool is_there = Guarded("read landmarks", [&] {
                            return Load(mesh.lock());
                          }).value_or(false);
    MutexLock lock(mutex_);
    if (is_there) {
      looked_.erase(digest);
    } else {
      looked_[digest] = true;
    }
  });
  return false;
}

absl::StatusOr<bool> LandmarkMaker::Load(const MeshHandle& mesh) {
  if (mesh == nullptr) return true;
  absl::StatusOr<Work> work = Begin(*mesh, /*may_read=*/true);
  if (!work.ok()) return work.status();
  if (!work->is_stored) return false;
  Publish(*mesh, *std::move(work));
  return true;
}

absl::StatusOr<LandmarkMaker::Work> LandmarkMaker::Begin(
    const ResidentMesh& mesh, bool may_read) {
  // Those of a turn that was broken off.
  const LandmarksHandle present = meshes_.landmarks().Find(mesh.digest);
  absl::StatusOr<ByteReservation> room =
      meshes_.landmarks().Reserve(*mesh.mesh);
  if (!room.ok()) return room.status();
  Work work{.room = *std::move(room)};
  if (present != nullptr) {
    work.landmarks = *present;
    return work;
  }
  if (files_ != nullptr && may_read) {
    absl::StatusOr<Landmarks> stored = files_->Load(mesh.digest, *mesh.mesh);
    if (stored.ok()) {
      loaded_ += stored->count();
      work.landmarks = *std::move(stored);
      work.is_stored = true;
      return work;
    }
  }
  work.landmarks = Landmarks(*mesh.mesh);
  return work;
}

absl::Status LandmarkMaker::AddNext(const ResidentMesh& mesh,
                                    Checkpoint& checkpoint,
                                    Landmarks& landmarks) {
  const absl::StatusOr<ValidQuery> query = ValidQuery::Make(
      {.sources = {{VertexPoint{*landmarks.next()}}}}, *mesh.mesh);
  if (!query.ok()) return query.status();
  auto field = start_(*mesh.mesh, *query, options_);
  if (!field.ok()) return field.status();
  absl::Status status = (*field)->Advance({}, checkpoint);
  if (!status.ok()) return status;
  landmarks.Add(*mesh.mesh, (*field)->Field().distances);
  ++made_;
  if (landmarks.next().has_value() && std::has_single_bit(landmarks.count())) {
    ShowCopy(mesh, landmarks);
  }
  return absl::OkStatus();
}

void LandmarkMaker::Store(const std::string& digest) {
  const LandmarksHandle landmarks = meshes_.landmarks().Find(digest);
  if (landmarks == nullptr || landmarks->next().has_value()) return;
  // A full disk does not hurt questions; uploads report it.
  (void)Guarded("kept landmarks",
                [&] { return files_->Put(digest, *landmarks); });
  // A mesh that was deleted before now had no file.
  if (!meshes_.Contains(digest)) files_->Erase(digest);
}

void LandmarkMaker::EraseMesh(const std::string& digest) {
  if (files_ != nullptr) files_->Erase(digest);
}

void LandmarkMaker::ShowCopy(const ResidentMesh& mesh,
                             const Landmarks& landmarks) {
  absl::StatusOr<ByteReservation> room =
      meshes_.landmarks().Reserve(*mesh.mesh);
  if (room.ok()) {
    Publish(mesh, {.room = *std::move(room), .landmarks = landmarks});
  }
}

void LandmarkMaker::Publish(const ResidentMesh& mesh, Work work) {
  LandmarkStore& store = meshes_.landmarks();
  const bool must_be_stored = files_ != nullptr && !work.is_stored &&
                              !work.landmarks->next().has_value();
  store.Insert(mesh.digest, *std::move(work.landmarks), std::move(work.room));
  // A mesh that went before now found no landmarks to take along.
  if (!meshes_.store().Holds(mesh.digest)) store.Erase(mesh.digest);
  if (must_be_stored) {
    scheduler_.Store([this, digest = mesh.digest] { Store(digest); });
  }
}

}  // namespace geodesic::server
