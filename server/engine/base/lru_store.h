// A store bounded in bytes that evicts the least recently used entries.
//
//   LruStore<std::string, Thing> store("thing store", 1 << 30);
//   absl::StatusOr<ByteReservation> room = store.Reserve(SizeOf(thing));
//   std::shared_ptr<const Thing> kept =
//       store.Insert("a", std::move(thing), *std::move(room)).value;
//
// Guarantees:
//   1. the charges of entries, of reservations and of removed entries that are
//      still held never add up to more than the capacity;
//   2. a handle pins its entry: the entry is not evicted while it is held;
//   3. room is made by evicting unpinned entries, least recently used first; if
//      that would not make enough room, nothing is evicted;
//   4. an entry never changes.

#ifndef GEODESIC_SERVER_ENGINE_BASE_LRU_STORE_H_
#define GEODESIC_SERVER_ENGINE_BASE_LRU_STORE_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/functional/function_ref.h"
#include "absl/status/statusor.h"
#include "server/engine/base/byte_budget.h"
#include "server/locks/mutex.h"

namespace geodesic::server {

// Thread-safe. Keys are ordered by <. O(log n) unless said otherwise.
template <typename Key, typename Value>
class LruStore {
 public:
  using Handle = std::shared_ptr<const Value>;

  // `removed` is called for each entry that is evicted or erased, under the
  // store's lock; it must be short and must not call the store.
  LruStore(std::string name, uint64_t capacity,
           std::function<void(const Key&)> removed = nullptr)
      : budget_(std::make_shared<ByteBudget>(std::move(name), capacity)),
        removed_(std::move(removed)) {}

  LruStore(const LruStore&) = delete;
  LruStore& operator=(const LruStore&) = delete;

  // Marks the entry as used. Null when absent.
  Handle Find(const Key& key) {
    MutexLock lock(mutex_);
    const auto it = entries_.find(key);
    if (it == entries_.end()) return nullptr;
    recency_.splice(recency_.end(), recency_, it->second.position);
    return ToHandle(it->second.charged);
  }

  // The same, but marks nothing as used.
  Handle Peek(const Key& key) const {
    MutexLock lock(mutex_);
    const auto it = entries_.find(key);
    return it == entries_.end() ? nullptr : ToHandle(it->second.charged);
  }

  // Whether so many bytes can ever be reserved. Errors: as Reserve.
  absl::Status CheckCapacity(uint64_t bytes) const {
    return budget_->CheckCapacity(bytes);
  }

  // Makes room. O(n) when something has to be evicted.
  // Errors: RESOURCE_EXHAUSTED naming the store, its capacity and the need.
  absl::StatusOr<ByteReservation> Reserve(uint64_t bytes) {
    MutexLock lock(mutex_);
    absl::StatusOr<ByteReservation> room =
        ByteReservation::Make(budget_, bytes);
    if (room.ok() || !EvictionMakesRoom(bytes)) return room;
    for (auto it = recency_.begin(); it != recency_.end() && !room.ok();) {
      const auto entry = entries_.find(**it++);
      if (IsPinned(entry->second)) continue;
      Remove(entry);
      ++evictions_;
      room = ByteReservation::Make(budget_, bytes);
    }
    return room;
  }

  struct Inserted {
    Handle value;
    bool is_new = false;
  };

  // Keeps `value` with `charge` until it is evicted or erased. An entry that
  // the key has already stays, and is marked as used, if `keep(present)` is
  // true; otherwise `value` replaces it.
  Inserted Insert(
      Key key, Value value, ByteReservation charge,
      absl::FunctionRef<bool(const Value& present)> keep = [](const Value&) {
        return true;
      }) {
    auto charged =
        std::make_shared<const Charged>(std::move(charge), std::move(value));
    // Allocated first, because an exception must not leave half an entry.
    std::list<const Key*> node(1, nullptr);
    MutexLock lock(mutex_);
    const auto [it, is_new] = entries_.try_emplace(std::move(key));
    if (is_new) {
      it->second.charged = std::move(charged);
      node.front() = &it->first;
      it->second.position = node.begin();
      recency_.splice(recency_.end(), node);
    } else {
      recency_.splice(recency_.end(), recency_, it->second.position);
      // `charged` frees the old value after the lock is released.
      if (!keep(it->second.charged->value)) it->second.charged.swap(charged);
    }
    return {ToHandle(it->second.charged), is_new};
  }

  // Removes the entry; handles to it stay valid. Returns whether there was one.
  bool Erase(const Key& key) {
    MutexLock lock(mutex_);
    const auto it = entries_.find(key);
    if (it == entries_.end()) return false;
    Remove(it);
    return true;
  }

  // Removes the entries whose key satisfies `predicate`. O(n).
  template <typename Predicate>
  void EraseIf(Predicate predicate) {
    MutexLock lock(mutex_);
    for (auto it = entries_.begin(); it != entries_.end();) {
      const auto entry = it++;
      if (predicate(entry->first)) Remove(entry);
    }
  }

  // Up to `count` entries in order of key, from the first key above `after`.
  // Marks nothing as used. O(log n + count).
  std::vector<Handle> List(const Key& after, size_t count) const {
    MutexLock lock(mutex_);
    std::vector<Handle> page;
    for (auto it = entries_.upper_bound(after);
         it != entries_.end() && page.size() < count; ++it) {
      page.push_back(ToHandle(it->second.charged));
    }
    return page;
  }

  size_t size() const {
    MutexLock lock(mutex_);
    return entries_.size();
  }

  // Entries evicted to make room, since the start.
  uint64_t evictions() const {
    MutexLock lock(mutex_);
    return evictions_;
  }

  // Includes reservations, and removed entries that are still held.
  uint64_t used_bytes() const { return budget_->used(); }

 private:
  // The charge returns to the budget when the value is freed, which may be
  // later than the entry's removal.
  struct Charged {
    Charged(ByteReservation c, Value v)
        : charge(std::move(c)), value(std::move(v)) {}
    ByteReservation charge;
    Value value;
  };
  struct Entry {
    std::shared_ptr<const Charged> charged;
    typename std::list<const Key*>::iterator position;
  };
  using Entries = std::map<Key, Entry>;

  static Handle ToHandle(const std::shared_ptr<const Charged>& charged) {
    return Handle(charged, &charged->value);
  }

  // The first handle to an entry is only made under mutex_, so a count of one
  // cannot grow while it is held.
  static bool IsPinned(const Entry& entry) {
    return entry.charged.use_count() > 1;
  }

  bool EvictionMakesRoom(uint64_t bytes) const
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    uint64_t room = budget_->capacity() - budget_->used();
    for (const auto& [key, entry] : entries_) {
      if (!IsPinned(entry)) room += entry.charged->charge.bytes();
    }
    return bytes <= room;
  }

  void Remove(typename Entries::iterator it)
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    if (removed_) removed_(it->first);
    recency_.erase(it->second.position);
    entries_.erase(it);
  }

  const std::shared_ptr<ByteBudget> budget_;
  const std::function<void(const Key&)> removed_;

  mutable Mutex mutex_;
  Entries entries_ ABSL_GUARDED_BY(mutex_);
  // Keys of entries_, oldest first.
  std::list<const Key*> recency_ ABSL_GUARDED_BY(mutex_);
  uint64_t evictions_ ABSL_GUARDED_BY(mutex_) = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_BASE_LRU_STORE_H_
