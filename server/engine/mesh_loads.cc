#include "server/engine/mesh_loads.h"

#include <memory>
#include <optional>
#include <utility>

#include "server/engine/guarded.h"

namespace geodesic::server {

absl::StatusOr<MeshLoads::Seat> MeshLoads::Join(const std::string& digest,
                                                MeshCallback done,
                                                const std::string& client) {
  std::lock_guard lock(mutex_);
  const uint64_t number = next_number_++;
  auto it = loads_.find(digest);
  if (it == loads_.end()) {
    // The lock is held until the load is on the list, so that its end cannot
    // come first.
    auto provision = std::make_shared<Provision>();
    absl::StatusOr<Scheduler::JobId> job = scheduler_.Submit(
        {.priority = JobPriority::kBuild,
         .client = client,
         .reserve = [this, digest,
                     provision] { return Provide(digest, *provision); },
         .run =
             [this, digest, number, provision](const std::stop_token& stop) {
               End(digest, number, Guarded("loaded a mesh", [&] {
                     return load_(digest, std::move(*provision), stop);
                   }));
             },
         .abandon =
             [this, digest, number](const absl::Status& why) {
               End(digest, number, why);
             }});
    if (!job.ok()) return job.status();
    it = loads_.emplace(digest, Load{.job = *job, .number = number}).first;
  }
  it->second.waiters.emplace(number, std::move(done));
  return Seat{digest, number};
}

void MeshLoads::Leave(const Seat& seat) {
  std::optional<Scheduler::JobId> job;
  {
    std::lock_guard lock(mutex_);
    const auto it = loads_.find(seat.digest);
    if (it == loads_.end() || it->second.waiters.erase(seat.number) == 0) {
      return;
    }
    if (!it->second.waiters.empty()) return;
    job = it->second.job;
    loads_.erase(it);
  }
  scheduler_.Cancel(*job);
}

absl::Status MeshLoads::Provide(const std::string& digest,
                                Provision& provision) const {
  absl::StatusOr<Provision> provided = provide_(digest);
  if (!provided.ok()) return provided.status();
  provision = *std::move(provided);
  return absl::OkStatus();
}

void MeshLoads::End(const std::string& digest, uint64_t number,
                    const absl::StatusOr<MeshHandle>& result) {
  std::map<uint64_t, MeshCallback> waiters;
  {
    std::lock_guard lock(mutex_);
    const auto it = loads_.find(digest);
    if (it == loads_.end() || it->second.number != number) return;
    waiters = std::move(it->second.waiters);
    loads_.erase(it);
  }
  for (auto& [seat, done] : waiters) done(result);
}

size_t MeshLoads::size() const {
  std::lock_guard lock(mutex_);
  return loads_.size();
}

}  // namespace geodesic::server
