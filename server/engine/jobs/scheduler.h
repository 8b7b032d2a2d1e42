// Runs jobs on an executor: so many at once, so many waiting, no more.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_SCHEDULER_H_
#define GEODESIC_SERVER_ENGINE_JOBS_SCHEDULER_H_

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/solve_options.h"
#include "server/engine/base/clock.h"
#include "server/engine/jobs/job_queue.h"
#include "server/engine/jobs/thread_pool.h"

namespace geodesic::server {

// How a job that ran spent its time.
struct JobTimes {
  JobPriority priority = JobPriority::kSolve;
  Duration waited{0};  // for a thread
  Duration ran{0};
  // It was asked to stop before its end.
  bool was_stopped = false;
};

// Thread-safe. job_queue.h says in which order jobs go.
//
// While the memory of the job whose turn it is is not there, it waits for
// running jobs to end, and nobody overtakes it: else a large job might never
// run. When none runs, others of the queue go first, for they hold memory, too
// (the meshes that they are about): the oldest whose own memory is there, one
// at a time, up to 256 of them. When there is none, nobody will give memory
// back, and the job is abandoned.
class Scheduler {
 public:
  using JobId = uint64_t;
  // Goes with its last copy.
  using Place = std::shared_ptr<void>;

  // Besides max_running jobs that run, max_queued may wait, of one client
  // max_queued_per_client. A place that is held counts like a job that waits.
  // REQUIRES: max_running > 0; `executor` outlives the scheduler.
  Scheduler(Executor& executor, size_t max_running, size_t max_queued,
            size_t max_queued_per_client = std::numeric_limits<size_t>::max());

  // Stops everything and waits for running jobs to return.
  // REQUIRES: the executor runs what it has been given.
  ~Scheduler();

  // From now on `ended` hears of each job that ran, from the job's thread.
  // `clock` outlives the scheduler. REQUIRES: no job has been submitted.
  void ObserveJobs(const Clock& clock,
                   std::function<void(const JobTimes&)> ended);

  // Errors: RESOURCE_EXHAUSTED with a retry hint when the queue is full, or the
  // client's share of it, which it then names as a quota; UNAVAILABLE after
  // BeginDrain. Continuations are spared all of these, but not UNAVAILABLE
  // after StopAll. The job's callbacks are then not called.
  absl::StatusOr<JobId> Submit(Job job);

  // A place in the queue for a question of many jobs, whose reader decides when
  // the next is due: while it is held, continuations may come, one that waits
  // at a time. Errors: as Submit. REQUIRES: it goes before the scheduler.
  absl::StatusOr<Place> HoldPlace(const std::string& client);

  // A waiting job is dropped, a running one asked to stop; neither callback is
  // called from here. Does nothing for a job that is gone.
  void Cancel(JobId id);

  // Makes a job that waits more urgent: somebody in a hurry waits for it, too.
  // Does nothing for a job that runs or is gone.
  void Expedite(JobId id, JobPriority priority);

  // From now on Submit fails; what was admitted goes on.
  void BeginDrain();
  bool is_draining() const;

  // BeginDrain; then waiting jobs are abandoned with UNAVAILABLE and running
  // ones asked to stop.
  void StopAll();

  // Waits until no job runs or waits. False when `limit` passed first.
  bool WaitIdle(std::chrono::milliseconds limit);

  size_t running() const;
  size_t queued() const;
  // Threads that no job has or waits for.
  size_t idle() const;

 private:
  void RunOne();
  TimePoint Now() const;
  // Runs the job; whether it goes on.
  bool Run(WaitingJob& started, const std::stop_source& source);

  // The rest REQUIRES: mutex_ held.

  // `runs_at_once`: if there is a thread for it.
  absl::Status CheckRoom(const std::string& client, bool runs_at_once) const;
  // Takes the memory of a job. Errors: as Job::reserve.
  static absl::Status Reserve(Job& job);
  // Asks the executor for as many threads as jobs may use.
  void AskForThreads();
  // The next job, if its memory is there. Those that will never get theirs are
  // told so, without the lock; `progressed` becomes true then.
  std::optional<WaitingJob> StartNext(std::unique_lock<std::mutex>& lock,
                                      JobId& id, bool& progressed);

  Executor& executor_;
  const size_t max_running_;
  const size_t max_queued_;
  const size_t max_queued_per_client_;
  // Set before the first job, then constant:
  const Clock* clock_ = nullptr;  // null: nobody asks for times
  std::function<void(const JobTimes&)> ended_;

  mutable std::mutex mutex_;
  std::condition_variable idle_;
  // Guarded by mutex_:
  JobQueue queue_;
  std::map<JobId, std::stop_source> running_;
  size_t workers_ = 0;  // tasks on the executor; <= max_running_
  uint64_t next_number_ = 0;
  bool draining_ = false;
  bool stopped_ = false;
};

// For a solve that starts now, in a job of the scheduler: it shares its work
// with as many threads as are idle, `most` in all. They are threads of its own:
// if other jobs come meanwhile, it takes a little of their processors until it
// ends, and waits for none of its threads that gets no turn.
inline SolveOptions WithIdleThreads(SolveOptions options,
                                    const Scheduler& scheduler, uint64_t most) {
  options.threads =
      static_cast<uint32_t>(std::min<uint64_t>(scheduler.idle() + 1, most));
  return options;
}

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_SCHEDULER_H_
