// The jobs that wait for a thread, in the order in which they get one.
//
//   1. A more urgent job goes before a less urgent one.
//   2. Of jobs that are equally urgent, clients take turns, a job each.
//   3. A client's jobs go in order of age.
//
// So that urgent work does not keep the rest away for ever, the rest gets one
// start of nine while it waits: the kind that was passed over most often (but
// kStore, which can wait). Between two such starts goes a job of the most
// urgent kind, so that it never waits for more than one less urgent one.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_JOB_QUEUE_H_
#define GEODESIC_SERVER_ENGINE_JOBS_JOB_QUEUE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
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

// Who asks, and how urgent it is to them.
struct Requester {
  // Names the client in messages to itself. Clients take turns, and each has a
  // share of the queue. Empty: the server itself, which has no share.
  std::string client;
  // Whether others, who wait for their answers, may go first.
  bool is_batch = false;
};

// The most urgent first.
enum class JobPriority {
  kBuild,  // of meshes: short, and queries wait for them
  kSolve,
  kRow,    // one of many that a single request needs
  kBatch,  // either of the two, of a request that can wait
  kStore,  // keeps on disk what would otherwise be computed again
};
inline constexpr int kJobPriorities = 5;

// The priority of what answers a request at once, and of its rows.
constexpr JobPriority SolvePriority(bool is_batch) {
  return is_batch ? JobPriority::kBatch : JobPriority::kSolve;
}
constexpr JobPriority RowPriority(bool is_batch) {
  return is_batch ? JobPriority::kBatch : JobPriority::kRow;
}

// Either `run` or `abandon` ends the job, unless it is cancelled while it
// waits: then neither is called. None of them may throw.
struct Job {
  JobPriority priority = JobPriority::kSolve;
  // See Requester.
  std::string client;
  // Whether it goes on with what was admitted before: it is then admitted too,
  // though the queue be full or draining, and takes no place in it.
  bool is_continuation = false;
  // Takes the memory that the job needs, just before it runs; may be empty.
  // Must be short. While it fails with a retry hint and other jobs may give
  // memory back, the job waits and is asked again (see Scheduler); any other
  // error is the job's end. What was taken goes with the job.
  absl::AnyInvocable<absl::Status()> reserve;
  // Does the work, on a thread of the executor. It should return soon after
  // the token asks it to stop.
  absl::AnyInvocable<void(std::stop_token)> run;
  // After `run`: whether there is more to do, for which the job waits in its
  // old place, takes memory and runs again; may be empty. One that was asked to
  // stop is dropped instead.
  absl::AnyInvocable<bool()> goes_on;
  // Hears why the job will never run. Must be short.
  absl::AnyInvocable<void(const absl::Status&)> abandon;
};

struct WaitingJob {
  Job job;
  TimePoint since;
  // Jobs that went before it because its memory was not there.
  uint64_t overtaken = 0;
};

// Not thread-safe. Jobs are known by numbers, the older the smaller.
// O(log n) unless said otherwise.
class JobQueue {
 public:
  // REQUIRES: the number is not in the queue.
  void Push(uint64_t number, WaitingJob waiting);

  // The job whose turn it is. REQUIRES: !empty().
  uint64_t Next() const;
  WaitingJob& waiting(uint64_t number) { return jobs_.at(number); }

  // The oldest job that `can_start`. O(n).
  std::optional<uint64_t> Oldest(absl::FunctionRef<bool(Job&)> can_start);

  // Takes out the next job, whose turn is over then. REQUIRES: !empty().
  WaitingJob Start();

  // Takes out a job that is not to start; nothing if it is not there.
  std::optional<WaitingJob> Remove(uint64_t number);

  // Makes a job more urgent. Nothing if it is not there, or is so already.
  void Expedite(uint64_t number, JobPriority priority);

  // Takes out all, in order of age. O(n).
  std::vector<WaitingJob> Clear();

  bool empty() const { return jobs_.empty(); }
  size_t size() const { return jobs_.size(); }

  // Takes a place for continuations that are yet to come, and gives it back.
  void Hold(const std::string& client);
  void Release(const std::string& client);

  // Those of jobs but continuations, and those that are held; of all, and of
  // one client.
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
    // Starts of more urgent jobs since one of these, or the last time none
    // waited.
    uint64_t passed_over = 0;
  };

  Lane& LaneOf(JobPriority priority) {
    return lanes_[static_cast<size_t>(priority)];
  }
  // The first that is not empty. REQUIRES: there is one.
  size_t MostUrgent() const;
  size_t NextLane() const;
  void Enter(uint64_t number, const Job& job);
  void Leave(uint64_t number, const Job& job);

  std::map<uint64_t, WaitingJob> jobs_;
  size_t places_ = 0;
  std::map<std::string, size_t> clients_;  // places of each that has any
  std::array<Lane, kJobPriorities> lanes_;
  // Starts in a row that left somebody less urgent behind.
  uint64_t passes_ = 0;
  size_t last_lane_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_JOB_QUEUE_H_
