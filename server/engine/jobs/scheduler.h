// Runs jobs on an executor, with a bound on how many run and how many wait.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_SCHEDULER_H_
#define GEODESIC_SERVER_ENGINE_JOBS_SCHEDULER_H_

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/solve_options.h"
#include "server/engine/base/clock.h"
#include "server/engine/jobs/job_queue.h"
#include "server/engine/jobs/processor_share.h"
#include "server/engine/jobs/thread_pool.h"
#include "server/locks/mutex.h"

namespace geodesic::server {

// How a job that ran spent its time.
struct JobTimes {
  JobPriority priority = JobPriority::kSolve;
  Duration waited{0};  // for a thread
  Duration ran{0};
  // Whether it was asked to stop before its end.
  bool was_stopped = false;
};

// Thread-safe. job_queue.h says in which order jobs go.
//
// If the next job's memory is not available, it waits for running jobs to end,
// and no other job starts; otherwise a large job might never run. If no job
// runs, others may overtake it, because waiting jobs also hold memory (their
// meshes): the oldest whose own memory is available goes first, one at a time,
// up to 256 of them. If there is none, no memory will come back, and the job is
// abandoned.
//
// A job that has run long lets another start beside it, if that is of a client
// of which fewer than max_running run: nobody waits for others' long jobs.
//
// Jobs that wait for the disk stand in a line of their own and have threads of
// their own, so that a slow disk delays nobody else. So do jobs of kPrepare,
// which run one at a time beside the others; they should rest while others run,
// and end when others wait for memory.
class Scheduler {
 public:
  using JobId = uint64_t;
  static constexpr Duration kBrief = std::chrono::milliseconds(5);
  // The place is given back with its last copy.
  using Place = std::shared_ptr<void>;

  // Up to max_running jobs run, beside those that have run long, and max_queued
  // wait, max_queued_per_client of them for one client. A place that is held
  // counts like a waiting job.
  // REQUIRES: max_running > 0; `executor` outlives the scheduler and, so that
  // no job waits for one, has ThreadsFor(max_running) threads for computing.
  Scheduler(Executor& executor, size_t max_running, size_t max_queued,
            size_t max_queued_per_client = std::numeric_limits<size_t>::max());

  static constexpr size_t ThreadsFor(size_t max_running) {
    return 4 * max_running;
  }

  // Stops everything and waits for running jobs to return.
  // REQUIRES: the executor runs what it has been given.
  ~Scheduler();

  // From now on `ended` is called for each job that ran, from the job's thread.
  // `clock` outlives the scheduler. REQUIRES: no job has been submitted.
  void ObserveJobs(const Clock& clock,
                   std::function<void(const JobTimes&)> ended);

  // Errors: RESOURCE_EXHAUSTED with a retry hint when the queue is full, or the
  // client's share of it is (a quota failure); UNAVAILABLE after BeginDrain. A
  // continuation only fails after StopAll, with UNAVAILABLE. After an error no
  // callback of the job is called.
  absl::StatusOr<JobId> Submit(Job job);

  // Writes to the disk, on a thread for that, what would otherwise be computed
  // again. Nobody waits for it; after StopAll it is dropped.
  void Store(absl::AnyInvocable<void()> write);

  // Takes a place in the queue for a question of many jobs, whose reader
  // decides when the next is due. While the place is held, its continuations
  // may be submitted; at most one of them waits at a time. Errors: as Submit.
  // REQUIRES: the place is released before the scheduler is destroyed.
  absl::StatusOr<Place> HoldPlace(const std::string& client);

  // Drops a waiting job, or asks a running one to stop; neither callback is
  // called from here. Does nothing for a job that is gone.
  void Cancel(JobId id);

  // Makes a waiting job more urgent, because somebody in a hurry has joined it.
  // Does nothing for a job that runs or is gone.
  void Expedite(JobId id, JobPriority priority);

  // Says, from the thread of a running job, for how long it has run. Returns
  // whether another may start beside it from now on: from kYoung on, and from
  // kBrief on if no client has used more than the job's, so that the short
  // questions of one who asks little do not wait for one who asks much.
  bool LetOthersStart(Duration ran);

  // From now on Submit fails, except for continuations; admitted jobs go on.
  void BeginDrain();
  bool is_draining() const;

  // BeginDrain; then abandons waiting jobs with UNAVAILABLE and asks running
  // ones to stop.
  void StopAll();

  // Waits until no job runs or waits. False when `limit` passed first.
  bool WaitIdle(std::chrono::milliseconds limit);

  size_t max_running() const { return max_running_; }
  // Of all priorities.
  size_t running() const;
  size_t queued() const;  // except kPrepare
  // Threads beyond those that running and waiting jobs take.
  size_t idle() const;
  // Whether jobs of more than one client run or wait.
  bool HasSeveralClients() const;
  // Whether half of the threads or more have jobs.
  bool is_busy() const;
  // Whether the next job waits for memory that others hold.
  bool lacks_memory() const;

 private:
  // Jobs of one kind of thread.
  struct Line {
    JobQueue queue;
    size_t running = 0;
    size_t long_running = 0;  // of them
    size_t stores = 0;        // of them: kStore
    size_t workers = 0;       // tasks on the executor
    // As of the last attempt to start one.
    bool lacks_memory = false;
  };

  struct StartedJob {
    JobId id;
    WaitingJob waiting;
    absl::Status memory;  // why it never gets its memory
  };
  struct RunningJob {
    std::stop_source source;
    std::thread::id thread;
    Line* line = nullptr;
    std::string client = {};
    bool is_long = false;
  };

  void RunOne(ThreadKind kind);
  TimePoint Now() const;
  // Runs the job, and says for how long; returns whether it goes on.
  bool Run(WaitingJob& started, const std::stop_source& source, Duration& ran);

  Line& LineOf(ThreadKind kind) ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return lines_[static_cast<size_t>(kind)];
  }
  const Line& LineOf(ThreadKind kind) const
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return lines_[static_cast<size_t>(kind)];
  }
  Line& LineOf(const Job& job) ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  // No thread has a job, or was asked to take one.
  bool IsIdle() const ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  // How many jobs of the line may start now.
  size_t FreeThreads(const Line& line) const
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  // The one that may start first, if there is one.
  std::optional<uint64_t> Next(const Line& line) const
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  // `runs_at_once`: the job needs no place if a thread is free for it.
  absl::Status CheckRoom(const std::string& client, bool runs_at_once) const
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  // Asks the executor for as many threads as jobs may use.
  void AskForThreads() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  // The next job, if its memory is available or never will be.
  std::optional<StartedJob> StartNext(Line& line)
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);

  Executor& executor_;
  const size_t max_running_;
  const size_t max_queued_;
  const size_t max_queued_per_client_;
  // Set before the first job, then constant:
  const Clock* clock_ = nullptr;  // null: nobody asks for times
  std::function<void(const JobTimes&)> ended_;

  mutable Mutex mutex_;
  std::condition_variable_any idle_;
  std::array<Line, kThreadKinds> lines_ ABSL_GUARDED_BY(mutex_);
  std::map<JobId, RunningJob> running_ ABSL_GUARDED_BY(mutex_);
  uint64_t next_number_ ABSL_GUARDED_BY(mutex_) = 0;
  bool draining_ ABSL_GUARDED_BY(mutex_) = false;
  bool stopped_ ABSL_GUARDED_BY(mutex_) = false;
};

// For a solve that starts now in a job of the scheduler: it shares its work
// with as many threads as are idle, `most` in all. The solve makes these
// threads itself. They compete for processors with jobs that start later, but
// the solve never waits for one that gets none.
inline SolveOptions WithIdleThreads(SolveOptions options,
                                    const Scheduler& scheduler, uint64_t most) {
  options.threads =
      static_cast<uint32_t>(std::min<uint64_t>(scheduler.idle() + 1, most));
  return options;
}

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_SCHEDULER_H_
