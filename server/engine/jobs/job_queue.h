// The jobs that wait for a thread, in the order in which they will get one.
//
//   1. A more urgent job goes before a less urgent one.
//   2. Among equally urgent jobs, the client goes first whose jobs have run for
//      the least time; those with as much take turns, one job each.
//   3. A client's jobs go in order of age.
//
// Urgent jobs must not delay the others for ever, so one start of nine goes to
// the less urgent kind that was passed over most often (never to kStore).
// Between two such starts goes a job of the most urgent kind, so it never waits
// for more than one less urgent job.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_JOB_QUEUE_H_
#define GEODESIC_SERVER_ENGINE_JOBS_JOB_QUEUE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "absl/functional/any_invocable.h"
#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "server/engine/base/clock.h"

namespace geodesic::server {

// The client that asks, and whether it can wait.
struct Requester {
  // The client's name in messages to it. Clients take turns, and each has a
  // share of the queue. Empty for the server itself, which has no share.
  std::string client;
  // Whether interactive requests may go first.
  bool is_batch = false;
  // What its quota counts for the request: see Waiter. May be null.
  std::shared_ptr<const void> account = {};
};

// The most urgent first.
enum class JobPriority {
  kBuild,  // a mesh build: short, and queries wait for it
  kSolve,
  kRow,      // one row of a matrix
  kBatch,    // a solve or row of a request that can wait
  kStore,    // keeps on disk what would otherwise be computed again
  kPrepare,  // makes what later questions would be faster with
};
inline constexpr int kJobPriorities = 6;

// The priority of what answers a request at once, and of its rows.
constexpr JobPriority SolvePriority(bool is_batch) {
  return is_batch ? JobPriority::kBatch : JobPriority::kSolve;
}
constexpr JobPriority RowPriority(bool is_batch) {
  return is_batch ? JobPriority::kBatch : JobPriority::kRow;
}

// A job ends with `run` or `abandon`; neither is called if it is cancelled
// while it waits. None of the functions may throw.
struct Job {
  JobPriority priority = JobPriority::kSolve;
  // See Requester.
  std::string client;
  // Whether the job continues work that was admitted before. It is then
  // admitted even if the queue is full or draining, and takes no place in it.
  bool is_continuation = false;
  // Takes the memory that the job needs, just before it runs; may be empty.
  // Must be short. If it fails with a retry hint and other jobs may give memory
  // back, the job waits and this is called again (see Scheduler); any other
  // error ends the job. Destroying the job returns the memory.
  absl::AnyInvocable<absl::Status()> reserve;
  // Whether its next run waits for the disk, and so has a thread of those that
  // do; may be empty. Must be short.
  absl::AnyInvocable<bool() const> waits_for_disk;
  // Does the work, on a thread of the executor. It should return soon after
  // the token asks it to stop.
  absl::AnyInvocable<void(std::stop_token)> run;
  // Called after `run`; returns whether there is more to do. If so, the job
  // waits in its old place, takes memory and runs again, unless it was asked to
  // stop: then it is dropped. May be empty.
  absl::AnyInvocable<bool()> goes_on;
  // Is told why the job will never run. Must be short.
  absl::AnyInvocable<void(const absl::Status&)> abandon;
};

struct WaitingJob {
  Job job;
  TimePoint since;
  // Jobs that started before it because its memory was not available.
  uint64_t overtaken = 0;
};

// Not thread-safe. Jobs are named by numbers; an older job has a smaller one.
// Calls are O(log n) unless they say otherwise.
class JobQueue {
 public:
  // REQUIRES: the number is not in the queue.
  void Push(uint64_t number, WaitingJob waiting);

  // The job whose turn it is. REQUIRES: !empty().
  uint64_t Next() const;
  WaitingJob& waiting(uint64_t number) { return jobs_.at(number); }
  const WaitingJob& waiting(uint64_t number) const { return jobs_.at(number); }

  // The oldest job that `can_start`. O(n).
  std::optional<uint64_t> Oldest(absl::FunctionRef<bool(Job&)> can_start);

  // The job whose turn it is if fewer than `most` of its client's run; else the
  // most urgent of such a client, who has used least; empty if there is none.
  // O(clients).
  std::optional<uint64_t> NextWithin(size_t most) const;

  // Takes out the next job and ends its client's turn; or that job, out of
  // turn. REQUIRES: !empty(); the job is in the queue. When it has ended, or
  // will not run, call Done.
  WaitingJob Start();
  WaitingJob StartOutOfTurn(uint64_t number);

  // A job of the client that was started has ended, and ran for so long. What a
  // client has used counts as long as it has jobs; one that comes later begins
  // with the least of the others'.
  void Done(const std::string& client, Duration ran);

  // Takes out a job that will not start; empty if it is not in the queue.
  std::optional<WaitingJob> Remove(uint64_t number);

  // Makes a job more urgent. Does nothing if it already is, or is not queued.
  void Expedite(uint64_t number, JobPriority priority);

  // Takes out all, in order of age. O(n).
  std::vector<WaitingJob> Clear();

  // Whether no client has used more. REQUIRES: it has jobs. O(clients).
  bool HasUsedMost(const std::string& client) const;

  // Those of whom jobs wait or run.
  size_t clients() const { return accounts_.size(); }
  bool empty() const { return jobs_.empty(); }
  size_t size() const { return jobs_.size(); }

  // Take a place for continuations that will come later, and give it back.
  void Hold(const std::string& client);
  void Release(const std::string& client);

  // Places taken by jobs, except continuations, and by Hold; in all, or by one
  // client.
  size_t places() const { return places_; }
  size_t places_of(const std::string& client) const;

 private:
  // A client's jobs of one kind.
  struct Line {
    std::string client;
    std::set<uint64_t> numbers;  // never empty
  };
  struct Lane {
    std::list<Line> turns;  // whose turn it is stands first
    std::map<std::string, std::list<Line>::iterator> lines;
    // Starts of more urgent jobs since one of this lane started, or since the
    // lane was last empty.
    uint64_t passed_over = 0;
  };

  Lane& LaneOf(JobPriority priority) {
    return lanes_[static_cast<size_t>(priority)];
  }
  // The first lane that is not empty. REQUIRES: there is one.
  size_t MostUrgent() const;
  size_t NextLane() const;
  // The line in front. REQUIRES: there is one. O(clients).
  std::list<Line>::const_iterator First(const Lane& lane) const;
  Duration Used(const Line& line) const {
    return accounts_.at(line.client).used;
  }
  WaitingJob Take(uint64_t number);
  void Close(const std::string& client);
  void Enter(uint64_t number, const Job& job);
  void Leave(uint64_t number, const Job& job);

  std::map<uint64_t, WaitingJob> jobs_;
  size_t places_ = 0;
  std::map<std::string, size_t> clients_;  // places of each that has any
  struct Account {
    Duration used{0};
    size_t jobs = 0;     // that wait or run
    size_t running = 0;  // of them
  };
  std::map<std::string, Account> accounts_;  // of clients that have any
  std::array<Lane, kJobPriorities> lanes_;
  // Starts in a row that passed over a less urgent job.
  uint64_t passes_ = 0;
  size_t last_lane_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_JOB_QUEUE_H_
