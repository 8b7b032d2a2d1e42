#include "server/engine/computation_store.h"

#include <utility>
#include <vector>

namespace geodesic::server {

ComputationStore::ComputationStore(uint64_t capacity)
    : budget_(std::make_shared<ByteBudget>("computation store", capacity)) {}

PausedComputation ComputationStore::Take(const FieldKey& key) {
  std::lock_guard lock(mutex_);
  const auto it = entries_.find(key);
  if (it == entries_.end()) return {};
  PausedComputation paused = std::move(it->second.paused);
  recency_.erase(it->second.position);
  entries_.erase(it);
  return paused;
}

bool ComputationStore::Contains(const FieldKey& key) const {
  std::lock_guard lock(mutex_);
  return entries_.contains(key);
}

void ComputationStore::Put(const FieldKey& key, PausedComputation paused) {
  const uint64_t bytes = paused.computation->bytes();
  if (bytes > budget_->capacity()) return;
  // Destroyed after the lock is released: they are large.
  std::vector<Entry> dropped;
  std::lock_guard lock(mutex_);
  if (entries_.contains(key)) return;
  // What is dropped here frees its charge at once; its memory follows.
  while (budget_->capacity() - budget_->used() < bytes && !recency_.empty()) {
    const auto oldest = entries_.find(recency_.front());
    oldest->second.charge.ShrinkTo(0);
    dropped.push_back(std::move(oldest->second));
    entries_.erase(oldest);
    recency_.pop_front();
  }
  absl::StatusOr<ByteReservation> charge =
      ByteReservation::Make(budget_, bytes);
  if (!charge.ok()) return;
  recency_.push_back(key);
  entries_.emplace(key, Entry{*std::move(charge), std::move(paused),
                              std::prev(recency_.end())});
}

void ComputationStore::EraseMesh(const std::string& digest) {
  std::vector<Entry> dropped;
  std::lock_guard lock(mutex_);
  for (auto it = entries_.begin(); it != entries_.end();) {
    const auto entry = it++;
    if (entry->first.mesh_digest != digest) continue;
    recency_.erase(entry->second.position);
    dropped.push_back(std::move(entry->second));
    entries_.erase(entry);
  }
}

void ComputationStore::Clear() {
  Entries dropped;
  std::lock_guard lock(mutex_);
  dropped.swap(entries_);
  recency_.clear();
}

size_t ComputationStore::size() const {
  std::lock_guard lock(mutex_);
  return entries_.size();
}

}  // namespace geodesic::server
