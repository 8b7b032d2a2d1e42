#include "server/engine/fields/field_writer.h"

#include <stop_token>
#include <utility>

#include "server/engine/base/guarded.h"

namespace geodesic::server {
namespace {

// A disk that is slower than the solvers is not to hold up anything.
constexpr size_t kMaxWaiting = 64;

}  // namespace

void FieldWriter::Enqueue(const FieldKey& key, const MeshHandle& mesh,
                          const FieldHandle& field) {
  std::lock_guard lock(mutex_);
  if (waiting_.size() >= kMaxWaiting) return;
  waiting_.push_back({key, mesh, field});
  if (!has_job_) SubmitJob();
}

void FieldWriter::SubmitJob() {
  has_job_ = scheduler_
                 .Submit({.priority = JobPriority::kStore,
                          .is_continuation = true,
                          .run = [this](const std::stop_token&) { WriteOne(); },
                          .abandon = [](const absl::Status&) {}})
                 .ok();
  // The server stops: nobody will ask.
  if (!has_job_) waiting_.clear();
}

void FieldWriter::WriteOne() {
  const Item item = [this] {
    std::lock_guard lock(mutex_);
    Item first = std::move(waiting_.front());
    waiting_.pop_front();
    return first;
  }();
  const MeshHandle mesh = item.mesh.lock();
  const FieldHandle field = item.field.lock();
  if (mesh != nullptr && field != nullptr) {
    // A disk that takes no more is no harm to those who ask; who upload hear
    // of it.
    (void)Guarded("kept a field",
                  [&] { return files_.Put(item.key, *mesh->mesh, *field); });
    // As FieldEngine::Keep.
    if (!meshes_.Contains(mesh->digest)) files_.EraseMesh(mesh->digest);
  }
  std::lock_guard lock(mutex_);
  has_job_ = false;
  if (!waiting_.empty()) SubmitJob();
}

}  // namespace geodesic::server
