#include "server/engine/scheduler.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "server/engine/error_reasons.h"
#include "server/engine/status_details.h"

namespace geodesic::server {
namespace {

// A queue moves on within about a second: most jobs take less.
constexpr std::chrono::milliseconds kRetryDelay{1000};

absl::Status ShuttingDown() {
  return WithReason(absl::UnavailableError("the server is shutting down"),
                    reason::kShuttingDown);
}

}  // namespace

Scheduler::Scheduler(Executor& executor, size_t max_running, size_t max_queued)
    : executor_(executor), max_running_(max_running), max_queued_(max_queued) {}

Scheduler::~Scheduler() {
  StopAll();
  std::unique_lock lock(mutex_);
  idle_.wait(lock, [this] { return workers_ == 0; });
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
  std::lock_guard lock(mutex_);
  if (stopped_ || (draining_ && !job.is_continuation)) return ShuttingDown();
  if (!job.is_continuation &&
      queue_.size() + running_.size() >= max_running_ + max_queued_) {
    return WithReason(
        WithRetryAfter(
            absl::ResourceExhaustedError(absl::StrCat(
                "the job queue is full: ", running_.size(), " jobs run and ",
                queue_.size(), " wait; try again later")),
            kRetryDelay),
        reason::kQueueFull);
  }
  const JobId id{job.priority, next_number_++};
  queue_.emplace(id, Waiting{std::move(job), Now()});
  if (workers_ < max_running_) {
    ++workers_;
    executor_.Schedule([this] { RunOne(); });
  }
  return id;
}

void Scheduler::Cancel(JobId id) {
  // Destroyed after the lock is released: what a job captured may be large.
  Job dropped;
  std::stop_source source(std::nostopstate);
  {
    std::lock_guard lock(mutex_);
    if (const auto it = queue_.find(id); it != queue_.end()) {
      dropped = std::move(it->second.job);
      queue_.erase(it);
    } else if (const auto run = running_.find(id); run != running_.end()) {
      source = run->second;
    }
  }
  source.request_stop();
}

void Scheduler::BeginDrain() {
  std::lock_guard lock(mutex_);
  draining_ = true;
}

void Scheduler::StopAll() {
  std::map<JobId, Waiting> abandoned;
  std::map<JobId, std::stop_source> stopped;
  {
    std::lock_guard lock(mutex_);
    draining_ = true;
    stopped_ = true;
    abandoned.swap(queue_);
    stopped = running_;
  }
  for (auto& [id, source] : stopped) source.request_stop();
  for (auto& [id, waiting] : abandoned) waiting.job.abandon(ShuttingDown());
}

bool Scheduler::WaitIdle(std::chrono::milliseconds limit) {
  std::unique_lock lock(mutex_);
  return idle_.wait_for(lock, limit,
                        [this] { return workers_ == 0 && queue_.empty(); });
}

size_t Scheduler::running() const {
  std::lock_guard lock(mutex_);
  return running_.size();
}

size_t Scheduler::queued() const {
  std::lock_guard lock(mutex_);
  return queue_.size();
}

void Scheduler::RunOne() {
  std::unique_lock lock(mutex_);
  if (!queue_.empty()) {
    const auto first = queue_.begin();
    const JobId id = first->first;
    Job job = std::move(first->second.job);
    JobTimes times{.priority = id.priority};
    const TimePoint begin = Now();
    times.waited = begin - first->second.since;
    queue_.erase(first);
    const std::stop_source source;
    running_.emplace(id, source);

    lock.unlock();
    job.run(source.get_token());
    job = Job();  // what it captured is gone before the job counts as done
    if (ended_) {
      times.ran = Now() - begin;
      times.was_stopped = source.stop_requested();
      ended_(times);
    }
    lock.lock();
    running_.erase(id);
  }
  // One task a job, so that an executor which others share stays fair.
  if (!queue_.empty()) {
    executor_.Schedule([this] { RunOne(); });
  } else {
    --workers_;
    idle_.notify_all();
  }
}

}  // namespace geodesic::server
