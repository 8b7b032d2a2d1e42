// Does work once for all clients that ask for the same.
//
//   SharedJobs<std::string, Mesh> loads(scheduler, clock, interval);
//   auto ticket = loads.Join(
//       digest, {.done = [](const absl::StatusOr<Mesh>& mesh) { ... }},
//       [&] { return SharedWork<Mesh>{.run = ...}; });
//   ...
//   loads.Leave(*ticket);  // unless it was told
//
// The first client starts the job, others join it. Each may leave or miss its
// own deadline. When no client is left, the job is dropped, or stops at its
// next poll; until then it counts as the last one's. A job that must not be
// joined gets a key of its own.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_SHARED_JOBS_H_
#define GEODESIC_SERVER_ENGINE_JOBS_SHARED_JOBS_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "absl/functional/any_invocable.h"
#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/base/status_details.h"
#include "server/engine/jobs/job_checkpoint.h"
#include "server/engine/jobs/scheduler.h"
#include "server/locks/mutex.h"

namespace geodesic::server {

// One client that waits for a job. Calls come from the job's thread, one at a
// time, and must be short. They may still come during Leave and just after.
template <typename Result>
struct Waiter {
  // The last call, at most once: the result or why there is none.
  std::function<void(const absl::StatusOr<Result>&)> done;
  // Each call replaces the one before. May be empty.
  std::function<void(const Progress&)> progress;
  TimePoint deadline = kNoDeadline;
  // Held while the client waits and, of the last one that does, until the work
  // has really ended. Dropped before `done` is called with a result.
  std::shared_ptr<const void> account = {};
};

template <typename Result, typename Shared = std::monostate>
struct SharedWork {
  std::string client;            // see Requester
  bool is_continuation = false;  // see Job
  // See Job. Must not call the SharedJobs.
  absl::AnyInvocable<absl::Status()> reserve;
  // Does the work. If it returns nullopt there is more to do: it runs again
  // after `reserve` succeeds again. The checkpoint says when to stop.
  absl::AnyInvocable<absl::StatusOr<std::optional<Result>>(JobCheckpoint&)> run;
  // See Job. Must not call the SharedJobs.
  absl::AnyInvocable<bool() const> waits_for_disk = {};
  // Data that all waiters can read while the job runs; may be null.
  std::shared_ptr<Shared> shared;
};

// Work that takes `bytes` of `budget` before it begins, for its checkpoint.
template <typename Result, typename Run>
SharedWork<Result> WorkInMemory(const std::shared_ptr<ByteBudget>& budget,
                                uint64_t bytes, const std::string& client,
                                Run run) {
  auto memory = std::make_shared<ByteReservation>();
  return {.client = client,
          .reserve = [budget, bytes, memory]() -> absl::Status {
            auto taken = ByteReservation::Make(budget, bytes);
            if (!taken.ok()) return taken.status();
            *memory = *std::move(taken);
            return absl::OkStatus();
          },
          .run = [memory, run = std::move(run)](JobCheckpoint& checkpoint)
              -> absl::StatusOr<std::optional<Result>> {
            checkpoint.Hold(std::move(*memory));
            return run(checkpoint);
          }};
}

// Thread-safe. Waiters are never called under a lock. Keys are ordered by <.
template <typename Key, typename Result, typename Shared = std::monostate>
class SharedJobs {
  struct Entry;

 public:
  // A place among those who wait.
  struct Ticket {
    std::shared_ptr<Entry> entry;  // null: nobody waits
    uint64_t number = 0;
    // Who started the job.
    bool is_first = false;
    std::shared_ptr<Shared> shared;
  };

  // REQUIRES: `scheduler` and `clock` outlive the object, and `scheduler` has
  // no job left when it is destroyed.
  SharedJobs(Scheduler& scheduler, const Clock& clock,
             Duration progress_interval)
      : scheduler_(scheduler),
        clock_(clock),
        progress_interval_(progress_interval) {}

  // Joins the job of this key and makes it at least as urgent as `priority`. If
  // there is none, submits what `make` returns; `make` must not call this
  // object. The waiter may be called before this returns.
  // Errors: as Scheduler::Submit; the waiter is then not called, and nobody has
  // joined.
  absl::StatusOr<Ticket> Join(
      const Key& key, Waiter<Result> waiter, JobPriority priority,
      absl::FunctionRef<SharedWork<Result, Shared>()> make) {
    // Held until the waiter is on the list, so the job cannot end before that,
    // and nobody joins a job that is refused.
    MutexLock lock(mutex_);
    const auto it = open_.find(key);
    std::shared_ptr<Entry> entry;
    if (it != open_.end()) {
      entry = it->second;
      scheduler_.Expedite(StateOf(*entry).job, priority);
    } else {
      entry = std::make_shared<Entry>(*this, key);
      absl::Status status = Submit(entry, priority, make());
      if (!status.ok()) return status;
      open_.emplace(key, entry);
    }
    const uint64_t number = next_number_++;
    State& state = StateOf(*entry);
    state.waiters.emplace(number, std::move(waiter));
    return Ticket{entry, number, it == open_.end(), state.shared};
  }

  // Does nothing when the job has ended.
  void Leave(const Ticket& ticket) {
    if (ticket.entry == nullptr) return;
    typename Waiters::node_type left;  // destroyed after the lock is released
    Scheduler::JobId job;
    {
      MutexLock lock(mutex_);
      State& state = StateOf(*ticket.entry);
      left = state.waiters.extract(ticket.number);
      if (left.empty() || !state.waiters.empty()) return;
      Close(*ticket.entry);
      Keep(state, left.mapped().account);
      job = state.job;
    }
    scheduler_.Cancel(job);
  }

  // Jobs that wait or run, and those who wait for them.
  size_t size() const {
    MutexLock lock(mutex_);
    return open_.size();
  }
  size_t waiters() const {
    MutexLock lock(mutex_);
    size_t count = 0;
    for (const auto& [key, entry] : open_) {
      count += StateOf(*entry).waiters.size();
    }
    return count;
  }

 private:
  using Waiters = std::map<uint64_t, Waiter<Result>>;
  using Work = SharedWork<Result, Shared>;

  // What the job's callbacks share. Its work is freed before any waiter hears
  // of the end, the rest with the job.
  struct Held {
    Work work;
    bool goes_on = false;
    // Of the last client, which has left. Guarded by mutex_ until the job ends.
    std::shared_ptr<const void> account = {};
  };

  struct State {
    Scheduler::JobId job = 0;
    std::shared_ptr<Shared> shared;
    Waiters waiters;
    std::weak_ptr<Held> held;
  };

  struct Entry final : public JobWaiters {
    Entry(SharedJobs& j, Key k) : jobs(j), key(std::move(k)) {}

    absl::Status Expire(TimePoint now) override {
      return jobs.Expire(*this, now);
    }
    void Publish(const Progress& progress) override {
      jobs.Publish(*this, progress);
    }

    SharedJobs& jobs;
    const Key key;
    State state;  // for StateOf alone
  };

  State& StateOf(Entry& entry) const ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return entry.state;
  }

  absl::Status Submit(const std::shared_ptr<Entry>& entry, JobPriority priority,
                      Work work) ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    State& state = StateOf(*entry);
    state.shared = std::move(work.shared);
    auto held = std::make_shared<Held>(Held{std::move(work)});
    Job job{.priority = priority,
            .client = held->work.client,
            .is_continuation = held->work.is_continuation};
    if (held->work.reserve) {
      job.reserve = [held] { return held->work.reserve(); };
    }
    if (held->work.waits_for_disk) {
      job.waits_for_disk = [held] {
        return held->work.waits_for_disk && held->work.waits_for_disk();
      };
    }
    job.run = [this, entry, held](std::stop_token stop) {
      absl::StatusOr<std::optional<Result>> result =
          Run(*entry, held->work, std::move(stop));
      held->goes_on = result.ok() && !result->has_value();
      if (held->goes_on) return;
      held->work = Work();
      if (result.ok()) {
        End(*entry, **std::move(result));
      } else {
        End(*entry, result.status());
      }
    };
    job.goes_on = [held] { return held->goes_on; };
    job.abandon = [this, entry, held](const absl::Status& why) {
      held->work = Work();
      End(*entry, why);
    };
    absl::StatusOr<Scheduler::JobId> id = scheduler_.Submit(std::move(job));
    if (id.ok()) state.job = *id;
    state.held = held;
    return id.status();
  }

  absl::StatusOr<std::optional<Result>> Run(Entry& entry, Work& work,
                                            std::stop_token stop) {
    JobCheckpoint checkpoint(entry, clock_, scheduler_, std::move(stop),
                             progress_interval_);
    absl::Status status = Expire(entry, clock_.Now());
    if (!status.ok()) return status;
    return Guarded("did a job", [&] { return work.run(checkpoint); });
  }

  // Removes the waiters whose deadline has come and tells them so.
  // Errors: DEADLINE_EXCEEDED or CANCELLED when nobody is left.
  absl::Status Expire(Entry& entry, TimePoint now) {
    const absl::Status late = absl::DeadlineExceededError(
        "the deadline came before the answer was computed");
    std::vector<Waiter<Result>> expired;
    bool is_abandoned = false;
    {
      MutexLock lock(mutex_);
      State& state = StateOf(entry);
      for (auto it = state.waiters.begin(); it != state.waiters.end();) {
        const auto waiter = it++;
        if (waiter->second.deadline > now) continue;
        expired.push_back(std::move(waiter->second));
        state.waiters.erase(waiter);
      }
      is_abandoned = state.waiters.empty();
      if (is_abandoned) Close(entry);
      if (is_abandoned && !expired.empty()) {
        Keep(state, expired.back().account);
      }
    }
    for (Waiter<Result>& waiter : expired) {
      waiter.account.reset();
      waiter.done(late);
    }
    if (!is_abandoned) return absl::OkStatus();
    return expired.empty() ? absl::CancelledError("nobody waits for the answer")
                           : late;
  }

  void Publish(Entry& entry, const Progress& progress) {
    std::vector<std::function<void(const Progress&)>> listeners;
    {
      MutexLock lock(mutex_);
      for (const auto& [number, waiter] : StateOf(entry).waiters) {
        if (waiter.progress) listeners.push_back(waiter.progress);
      }
    }
    for (const auto& listener : listeners) listener(progress);
  }

  // From now on a question starts another job, so the result must be stored
  // where questions find it before this call.
  void End(Entry& entry, const absl::StatusOr<Result>& result) {
    Waiters waiters;
    {
      MutexLock lock(mutex_);
      waiters.swap(StateOf(entry).waiters);
      Close(entry);
    }
    for (auto& [number, waiter] : waiters) {
      waiter.account.reset();
      waiter.done(result);
    }
  }

  // Nobody waits any longer: keeps the last one's account as long as the job.
  void Keep(const State& state, std::shared_ptr<const void>& account)
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    if (const auto held = state.held.lock()) held->account = std::move(account);
  }

  void Close(const Entry& entry) ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    const auto it = open_.find(entry.key);
    // Another job may have taken the key since this one was closed.
    if (it != open_.end() && it->second.get() == &entry) open_.erase(it);
  }

  Scheduler& scheduler_;
  const Clock& clock_;
  const Duration progress_interval_;

  // Taken before the scheduler's.
  mutable Mutex mutex_;
  std::map<Key, std::shared_ptr<Entry>> open_ ABSL_GUARDED_BY(mutex_);
  uint64_t next_number_ ABSL_GUARDED_BY(mutex_) = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_SHARED_JOBS_H_
