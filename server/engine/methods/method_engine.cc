#include "server/engine/methods/method_engine.h"

#include <chrono>
#include <utility>

#include "geodesic/solve_options.h"
#include "geodesic_types/field_path.h"

namespace geodesic::server {
namespace {

// For the work's arrays before it has told how much it takes.
uint64_t PlannedBytes(const Mesh& mesh) { return mesh.resident_bytes() / 4; }

}  // namespace

MethodEngine::MethodEngine(const Limits& limits, const Clock& clock,
                           Scheduler& scheduler,
                           std::shared_ptr<ByteBudget> solver_memory,
                           MeshLibrary& meshes)
    : limits_(limits),
      clock_(clock),
      scheduler_(scheduler),
      solver_memory_(std::move(solver_memory)),
      meshes_(meshes),
      jobs_(scheduler, clock, limits.progress_interval) {}

absl::StatusOr<MethodJobs::Ticket> MethodEngine::Prepare(
    const MeshHandle& mesh, const MethodChoice& method,
    Waiter<MethodHandle> waiter, const Requester& requester) {
  // A key must not be NaN.
  if (absl::Status status = Validate(method); !status.ok()) return status;
  const uint64_t planned = PlannedBytes(*mesh->mesh);
  absl::Status fits = solver_memory_->CheckCapacity(planned);
  if (!fits.ok()) return fits;
  waiter.account = requester.account;
  return jobs_.Join({mesh->digest, method}, std::move(waiter),
                    SolvePriority(requester.is_batch), [&] {
                      return Work(mesh, method, planned, requester.client);
                    });
}

SharedWork<MethodHandle> MethodEngine::Work(const MeshHandle& mesh,
                                            const MethodChoice& method,
                                            uint64_t planned_bytes,
                                            const std::string& client) {
  // The disk may be slow: a graph is looked for on a thread for that.
  const auto may_be_kept = std::make_shared<std::atomic<bool>>(
      method.method == ApproximateMethod::kSvg && files_ != nullptr &&
      !Find(mesh, method));
  auto work = WorkInMemory<MethodHandle>(
      solver_memory_, planned_bytes, client,
      [this, mesh, method, may_be_kept](Checkpoint& checkpoint)
          -> absl::StatusOr<std::optional<MethodHandle>> {
        if (may_be_kept->exchange(false)) return Load(mesh, method);
        return Run(mesh, method, checkpoint);
      });
  work.waits_for_disk = [may_be_kept] { return may_be_kept->load(); };
  return work;
}

absl::StatusOr<std::optional<MethodHandle>> MethodEngine::Load(
    const MeshHandle& mesh, const MethodChoice& method) {
  const TimePoint begin = clock_.Now();
  auto stored = files_->Load(mesh->digest, method.neighbours, *mesh->mesh);
  // It is made, on a thread for that.
  if (!stored.ok()) return std::nullopt;
  ++loaded_;
  return Keep(mesh, method, *std::move(stored), begin);
}

absl::StatusOr<MethodHandle> MethodEngine::Run(const MeshHandle& mesh,
                                               const MethodChoice& method,
                                               Checkpoint& checkpoint) {
  if (std::optional<MethodHandle> found = Find(mesh, method)) {
    return *std::move(found);
  }
  const TimePoint begin = clock_.Now();
  auto made = Make(*mesh, method, checkpoint);
  if (!made.ok()) return made.status();
  return Keep(mesh, method, *std::move(made), begin);
}

absl::StatusOr<MethodHandle> MethodEngine::Keep(
    const MeshHandle& mesh, const MethodChoice& method,
    std::shared_ptr<const PreparedMethod> made, TimePoint begin) {
  const std::chrono::duration<double> took = clock_.Now() - begin;
  absl::StatusOr<MethodHandle> kept =
      meshes_.methods().Insert({.mesh = mesh,
                                .choice = method,
                                .method = std::move(made),
                                .prepare_seconds = took.count()});
  // A mesh that went before now found nothing to take along.
  if (!meshes_.store().Holds(mesh->digest)) {
    meshes_.methods().EraseMesh(mesh->digest);
  }
  return kept;
}

absl::StatusOr<std::shared_ptr<const PreparedMethod>> MethodEngine::Make(
    const ResidentMesh& mesh, const MethodChoice& choice,
    Checkpoint& checkpoint) {
  auto made = PrepareMethod(
      *mesh.mesh, choice,
      WithIdleThreads({}, scheduler_, limits_.max_threads_per_solve).threads,
      checkpoint);
  if (!made.ok()) return made.status();
  ++made_;
  if (choice.method == ApproximateMethod::kSvg && files_ != nullptr) {
    scheduler_.Store([this, digest = mesh.digest, graph = *made,
                      neighbours = choice.neighbours] {
      // A full disk does not hurt questions; uploads report it.
      (void)Guarded("kept a graph", [&] {
        return files_->Put(digest, neighbours,
                           static_cast<const SaddleVertexGraph&>(*graph));
      });
      // A mesh that was deleted before now had no file.
      if (!meshes_.Contains(digest)) files_->EraseMesh(digest);
    });
  }
  return made;
}

void MethodEngine::EraseMesh(const std::string& digest) {
  meshes_.methods().EraseMesh(digest);
  if (files_ != nullptr) files_->EraseMesh(digest);
}

}  // namespace geodesic::server
