// Runs jobs on an executor: so many at once, so many waiting, no more.

#ifndef GEODESIC_SERVER_ENGINE_SCHEDULER_H_
#define GEODESIC_SERVER_ENGINE_SCHEDULER_H_

#include <chrono>
#include <compare>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>

#include "absl/functional/any_invocable.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/engine/clock.h"
#include "server/engine/executor.h"

namespace geodesic::server {

enum class JobPriority {
  kBuild,  // of meshes: short, and queries wait for them
  kSolve,
  kRow,    // one of many that a single request needs
  kStore,  // keeps on disk what would otherwise be computed again
};

// Exactly one of the two is called, once, unless the job is cancelled while it
// waits: then neither is.
struct Job {
  JobPriority priority = JobPriority::kSolve;
  // Whether a job that was admitted goes on in this one: it is then admitted
  // too, though the queue be full or draining.
  bool is_continuation = false;
  // Does the work, on a thread of the executor. It should return soon after
  // the token asks it to stop. Must not throw.
  absl::AnyInvocable<void(std::stop_token)> run;
  // Hears why the job will never run. Must be short.
  absl::AnyInvocable<void(const absl::Status&)> abandon;
};

// How a job that ran spent its time.
struct JobTimes {
  JobPriority priority = JobPriority::kSolve;
  Duration waited{0};  // for a thread
  Duration ran{0};
  // It was asked to stop before its end.
  bool was_stopped = false;
};

// Thread-safe. Among waiting jobs, priority and then age decide.
class Scheduler {
 public:
  struct JobId {
    JobPriority priority = JobPriority::kSolve;
    uint64_t number = 0;
    friend auto operator<=>(const JobId&, const JobId&) = default;
  };

  // REQUIRES: max_running > 0; `executor` outlives the scheduler.
  Scheduler(Executor& executor, size_t max_running, size_t max_queued);

  // Stops everything and waits for running jobs to return.
  // REQUIRES: the executor runs what it has been given.
  ~Scheduler();

  // From now on `ended` hears of each job that ran, from the job's thread.
  // `clock` outlives the scheduler. REQUIRES: no job has been submitted.
  void ObserveJobs(const Clock& clock,
                   std::function<void(const JobTimes&)> ended);

  // Errors: RESOURCE_EXHAUSTED with a retry hint when max_running jobs run and
  // max_queued wait; UNAVAILABLE after BeginDrain. Continuations are spared
  // both, but not UNAVAILABLE after StopAll. The job's callbacks are then not
  // called.
  absl::StatusOr<JobId> Submit(Job job);

  // A waiting job is dropped, a running one asked to stop; neither callback is
  // called from here. Does nothing for a job that is gone.
  void Cancel(JobId id);

  // From now on Submit fails; what was admitted goes on.
  void BeginDrain();

  // BeginDrain; then waiting jobs are abandoned with UNAVAILABLE and running
  // ones asked to stop.
  void StopAll();

  // Waits until no job runs or waits. False when `limit` passed first.
  bool WaitIdle(std::chrono::milliseconds limit);

  size_t running() const;
  size_t queued() const;

 private:
  struct Waiting {
    Job job;
    TimePoint since;
  };

  void RunOne();
  TimePoint Now() const;

  Executor& executor_;
  const size_t max_running_;
  const size_t max_queued_;
  // Set before the first job, then constant:
  const Clock* clock_ = nullptr;  // null: nobody asks for times
  std::function<void(const JobTimes&)> ended_;

  mutable std::mutex mutex_;
  std::condition_variable idle_;
  // Guarded by mutex_:
  std::map<JobId, Waiting> queue_;
  std::map<JobId, std::stop_source> running_;
  size_t workers_ = 0;  // tasks on the executor; <= max_running_
  uint64_t next_number_ = 0;
  bool draining_ = false;
  bool stopped_ = false;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_SCHEDULER_H_
