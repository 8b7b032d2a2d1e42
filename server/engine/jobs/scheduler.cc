#include "server/engine/jobs/scheduler.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "server/engine/base/status_details.h"

namespace geodesic::server {
namespace {

// Of the disk's threads: what nobody waits for leaves others to those who do.
constexpr size_t kStoreThreads = kDiskThreads / 2;

// The default of max_queued_jobs.
constexpr uint64_t kMostOvertaken = 256;

// Takes the memory of a job. Errors: as Job::reserve.
absl::Status Reserve(Job& job) {
  if (!job.reserve) return absl::OkStatus();
  return Guarded("made room for a job", [&] { return job.reserve(); });
}

}  // namespace

Scheduler::Scheduler(Executor& executor, size_t max_running, size_t max_queued,
                     size_t max_queued_per_client)
    : executor_(executor),
      max_running_(max_running),
      max_queued_(max_queued),
      max_queued_per_client_(max_queued_per_client) {}

Scheduler::~Scheduler() {
  StopAll();
  MutexLock lock(mutex_);
  while (!IsIdle()) idle_.wait(lock);
}

void Scheduler::ObserveJobs(const Clock& clock,
                            std::function<void(const JobTimes&)> ended) {
  clock_ = &clock;
  ended_ = std::move(ended);
}

TimePoint Scheduler::Now() const {
  return clock_ == nullptr ? TimePoint() : clock_->Now();
}

absl::StatusOr<Scheduler::JobId> Scheduler::Submit(Job job) {
  MutexLock lock(mutex_);
  if (stopped_) return ShuttingDown();
  if (!job.is_continuation) {
    absl::Status status = CheckRoom(job.client, /*runs_at_once=*/true);
    if (!status.ok()) return status;
  }
  const JobId id = next_number_++;
  Line& line = LineOf(job);
  line.queue.Push(id, {std::move(job), Now()});
  AskForThreads();
  return id;
}

void Scheduler::Store(absl::AnyInvocable<void()> write) {
  (void)Submit({.priority = JobPriority::kStore,
                .is_continuation = true,
                .waits_for_disk = [] { return true; },
                .run = [write = std::move(write)](
                           const std::stop_token&) mutable { write(); },
                .abandon = [](const absl::Status&) {}});
}

absl::StatusOr<Scheduler::Place> Scheduler::HoldPlace(
    const std::string& client) {
  MutexLock lock(mutex_);
  absl::Status status = CheckRoom(client, /*runs_at_once=*/false);
  if (!status.ok()) return status;
  LineOf(ThreadKind::kCompute).queue.Hold(client);
  return Place(this, [client](Scheduler* scheduler) {
    MutexLock release_lock(scheduler->mutex_);
    scheduler->LineOf(ThreadKind::kCompute).queue.Release(client);
  });
}

absl::Status Scheduler::CheckRoom(const std::string& client,
                                  bool runs_at_once) const {
  if (draining_) return ShuttingDown();
  // A job for which a thread is free does not wait.
  const size_t free_threads = FreeThreads(LineOf(ThreadKind::kCompute));
  size_t all_places = 0, places = 0;
  for (const ThreadKind kind : {ThreadKind::kCompute, ThreadKind::kDisk}) {
    const JobQueue& queue = LineOf(kind).queue;
    all_places += queue.places();
    if (!client.empty()) places += queue.places_of(client);
  }
  if (runs_at_once &&
      LineOf(ThreadKind::kCompute).queue.size() < free_threads) {
    return absl::OkStatus();
  }
  if (all_places >= max_queued_ + free_threads) {
    return WithReason(
        WithRetryAfter(
            absl::ResourceExhaustedError(absl::StrCat(
                "the job queue is full: ", running_.size(), " jobs run and ",
                all_places,
                " wait, or are matrices that go on; try again later")),
            kRetryDelay),
        reason::kQueueFull);
  }
  // Written so that the largest limit, which means none, does not overflow.
  if (places < free_threads || places - free_threads < max_queued_per_client_) {
    return absl::OkStatus();
  }
  return WithQuotaFailure(
      WithRetryAfter(absl::ResourceExhaustedError(absl::StrCat(
                         places, " jobs of ", client,
                         " wait, or are matrices that go on: its share of the "
                         "queue (max_queued_jobs_per_client is ",
                         max_queued_per_client_, "); try again later")),
                     kRetryDelay),
      client);
}

size_t Scheduler::FreeThreads(const Line& line) const {
  size_t most = 1;
  if (&line == &LineOf(ThreadKind::kDisk)) most = kDiskThreads;
  if (&line == &LineOf(ThreadKind::kCompute)) {
    most = std::min(max_running_ + line.long_running, ThreadsFor(max_running_));
  }
  return most - line.running;
}

std::optional<uint64_t> Scheduler::Next(const Line& line) const {
  if (FreeThreads(line) == 0) return std::nullopt;
  const std::optional<uint64_t> next = line.queue.NextWithin(
      &line == &LineOf(ThreadKind::kCompute) ? max_running_ : kDiskThreads);
  const bool is_store =
      next.has_value() &&
      line.queue.waiting(*next).job.priority == JobPriority::kStore;
  return is_store && line.stores == kStoreThreads ? std::nullopt : next;
}

void Scheduler::AskForThreads() {
  for (const ThreadKind kind :
       {ThreadKind::kCompute, ThreadKind::kDisk, ThreadKind::kBeside}) {
    Line& line = LineOf(kind);
    if (!Next(line).has_value()) continue;
    // A thread for each job that runs, and one for each that might.
    const size_t wanted =
        line.running + std::min(FreeThreads(line), line.queue.size());
    while (line.workers < wanted) {
      ++line.workers;
      executor_.Schedule([this, kind] { RunOne(kind); }, kind);
    }
  }
}

bool Scheduler::LetOthersStart(Duration ran) {
  if (ran < kBrief) return false;
  MutexLock lock(mutex_);
  const auto job = std::ranges::find_if(running_, [](const auto& running) {
    return running.second.thread == std::this_thread::get_id() &&
           !running.second.is_long;
  });
  if (job == running_.end()) return true;
  if (ran < kYoung && !job->second.line->queue.HasUsedMost(job->second.client))
    return false;
  job->second.is_long = true;
  ++job->second.line->long_running;
  AskForThreads();
  return true;
}

void Scheduler::Cancel(JobId id) {
  // Destroyed after the lock is released: what a job captured may be large.
  std::optional<WaitingJob> dropped;
  std::stop_source source(std::nostopstate);
  {
    MutexLock lock(mutex_);
    for (Line& line : lines_) {
      if (!dropped.has_value()) dropped = line.queue.Remove(id);
    }
    if (dropped.has_value()) {
      // The other jobs may have waited behind this one.
      AskForThreads();
    } else if (const auto run = running_.find(id); run != running_.end()) {
      source = run->second.source;
    }
  }
  source.request_stop();
}

void Scheduler::Expedite(JobId id, JobPriority priority) {
  MutexLock lock(mutex_);
  for (Line& line : lines_) line.queue.Expedite(id, priority);
  AskForThreads();
}

void Scheduler::BeginDrain() {
  MutexLock lock(mutex_);
  draining_ = true;
}

bool Scheduler::is_draining() const {
  MutexLock lock(mutex_);
  return draining_;
}

void Scheduler::StopAll() {
  std::vector<WaitingJob> abandoned;
  std::vector<std::stop_source> stopped;
  {
    MutexLock lock(mutex_);
    draining_ = true;
    stopped_ = true;
    for (Line& line : lines_) {
      std::ranges::move(line.queue.Clear(), std::back_inserter(abandoned));
    }
    for (const auto& [id, job] : running_) stopped.push_back(job.source);
  }
  for (std::stop_source& source : stopped) source.request_stop();
  for (WaitingJob& waiting : abandoned) waiting.job.abandon(ShuttingDown());
}

bool Scheduler::WaitIdle(std::chrono::milliseconds limit) {
  MutexLock lock(mutex_);
  return idle_.wait_for(
      lock, limit, [this]() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
        return IsIdle() && std::ranges::all_of(lines_, [](const Line& line) {
                 return line.queue.empty();
               });
      });
}

bool Scheduler::IsIdle() const {
  return std::ranges::all_of(
      lines_, [](const Line& line) { return line.workers == 0; });
}

Scheduler::Line& Scheduler::LineOf(const Job& job) {
  if (job.priority == JobPriority::kPrepare) return LineOf(ThreadKind::kBeside);
  return LineOf(job.waits_for_disk && job.waits_for_disk()
                    ? ThreadKind::kDisk
                    : ThreadKind::kCompute);
}

size_t Scheduler::running() const {
  MutexLock lock(mutex_);
  return running_.size();
}

size_t Scheduler::idle() const {
  MutexLock lock(mutex_);
  const Line& line = LineOf(ThreadKind::kCompute);
  const size_t taken = line.running + line.queue.size();
  return taken < max_running_ ? max_running_ - taken : 0;
}

bool Scheduler::HasSeveralClients() const {
  MutexLock lock(mutex_);
  return LineOf(ThreadKind::kCompute).queue.clients() > 1;
}

bool Scheduler::is_busy() const {
  MutexLock lock(mutex_);
  return 2 * LineOf(ThreadKind::kCompute).running >= max_running_;
}

bool Scheduler::lacks_memory() const {
  MutexLock lock(mutex_);
  const auto lacks = [](const Line& line) {
    return line.lacks_memory && !line.queue.empty();
  };
  return lacks(LineOf(ThreadKind::kCompute)) ||
         lacks(LineOf(ThreadKind::kDisk));
}

size_t Scheduler::queued() const {
  MutexLock lock(mutex_);
  return LineOf(ThreadKind::kCompute).queue.size() +
         LineOf(ThreadKind::kDisk).queue.size();
}

void Scheduler::RunOne(ThreadKind kind) {
  MutexLock lock(mutex_);
  Line& line = LineOf(kind);
  bool progressed = false;
  std::optional<StartedJob> started = StartNext(line);
  for (; started && !started->memory.ok(); started = StartNext(line)) {
    progressed = true;
    line.queue.Done(started->waiting.job.client, Duration{0});
    lock.unlock();
    started->waiting.job.abandon(started->memory);
    started.reset();
    lock.lock();
  }
  if (started) {
    progressed = true;
    const JobId id = started->id;
    const std::stop_source source;
    running_[id] = {source, std::this_thread::get_id(), &line,
                    started->waiting.job.client};
    ++line.running;
    const bool is_store = started->waiting.job.priority == JobPriority::kStore;
    if (is_store) ++line.stores;
    const std::string client = started->waiting.job.client;
    lock.unlock();
    Duration ran{0};
    bool goes_on = Run(started->waiting, source, ran);
    lock.lock();
    line.queue.Done(client, ran);
    if (goes_on && !stopped_ && !source.stop_requested()) {
      Line& next = LineOf(started->waiting.job);
      next.queue.Push(id, {std::move(started->waiting.job), Now()});
    } else if (goes_on) {
      // Frees what the job captured without the lock, before it counts as done.
      const bool is_end = stopped_;
      lock.unlock();
      if (is_end) started->waiting.job.abandon(ShuttingDown());
      started.reset();
      lock.lock();
    }
    if (running_.at(id).is_long) --line.long_running;
    if (is_store) --line.stores;
    running_.erase(id);
    --line.running;
  }
  --line.workers;
  // Each task runs one job, which is fair to others who share the executor.
  // When no job could start, the next change asks again.
  if (progressed) AskForThreads();
  if (IsIdle()) idle_.notify_all();
}

bool Scheduler::Run(WaitingJob& started, const std::stop_source& source,
                    Duration& ran) {
  JobTimes times{.priority = started.job.priority};
  const TimePoint begin = Now();
  times.waited = begin - started.since;
  started.job.run(source.get_token());
  const bool goes_on = started.job.goes_on && started.job.goes_on();
  // What the job captured is freed before the job counts as done.
  if (!goes_on) started.job = Job();
  ran = Now() - begin;
  if (ended_) {
    times.ran = ran;
    times.was_stopped = source.stop_requested();
    ended_(times);
  }
  return goes_on;
}

std::optional<Scheduler::StartedJob> Scheduler::StartNext(Line& line) {
  const std::optional<JobId> id = Next(line);
  if (!id.has_value()) return std::nullopt;
  JobQueue& queue = line.queue;
  WaitingJob& next = queue.waiting(*id);
  absl::Status memory = Reserve(next.job);
  line.lacks_memory = RetryAfter(memory).has_value();
  if (line.lacks_memory) {
    if (!running_.empty()) return std::nullopt;
    const auto can_start = [](Job& job) { return Reserve(job).ok(); };
    const std::optional<JobId> other = next.overtaken < kMostOvertaken
                                           ? queue.Oldest(can_start)
                                           : std::nullopt;
    if (other.has_value()) {
      ++next.overtaken;
      return StartedJob{*other, queue.StartOutOfTurn(*other)};
    }
  }
  return StartedJob{
      *id, *id == queue.Next() ? queue.Start() : queue.StartOutOfTurn(*id),
      std::move(memory)};
}

}  // namespace geodesic::server
