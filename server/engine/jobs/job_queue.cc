#include "server/engine/jobs/job_queue.h"

#include <algorithm>
#include <utility>

namespace geodesic::server {
namespace {

// Starts in a row that may pass over waiting jobs that are less urgent.
constexpr uint64_t kPatience = 8;

constexpr auto kStoreLane = static_cast<size_t>(JobPriority::kStore);

}  // namespace

void JobQueue::Push(uint64_t number, WaitingJob waiting) {
  const Job& job = jobs_.emplace(number, std::move(waiting)).first->second.job;
  if (!job.is_continuation) Hold(job.client);
  const auto used = [](const auto& account) { return account.second.used; };
  const auto least = std::ranges::min_element(accounts_, {}, used);
  const Account newcomer = {.used = least == accounts_.end() ? Duration{0}
                                                             : used(*least)};
  ++accounts_.try_emplace(job.client, newcomer).first->second.jobs;
  Enter(number, job);
}

void JobQueue::Done(const std::string& client, Duration ran) {
  Account& account = accounts_.at(client);
  account.used += ran;
  --account.running;
  Close(client);
}

void JobQueue::Close(const std::string& client) {
  const auto account = accounts_.find(client);
  if (--account->second.jobs == 0) accounts_.erase(account);
}

std::list<JobQueue::Line>::const_iterator JobQueue::First(
    const Lane& lane) const {
  return std::ranges::min_element(
      lane.turns, {}, [this](const Line& line) { return Used(line); });
}

size_t JobQueue::MostUrgent() const {
  size_t lane = 0;
  while (lanes_[lane].turns.empty()) ++lane;
  return lane;
}

size_t JobQueue::NextLane() const {
  const size_t urgent = MostUrgent();
  if (passes_ < kPatience || last_lane_ > urgent) return urgent;
  size_t next = urgent;
  for (size_t lane = urgent + 1; lane < kStoreLane; ++lane) {
    if (lanes_[lane].turns.empty()) continue;
    if (next == urgent || lanes_[lane].passed_over > lanes_[next].passed_over) {
      next = lane;
    }
  }
  return next;
}

uint64_t JobQueue::Next() const {
  return *First(lanes_[NextLane()])->numbers.begin();
}

std::optional<uint64_t> JobQueue::NextWithin(size_t most) const {
  if (empty()) return std::nullopt;
  const auto may_start = [&](const std::string& client) {
    return accounts_.at(client).running < most;
  };
  if (may_start(jobs_.at(Next()).job.client)) return Next();
  for (const Lane& lane : lanes_) {
    const Line* first = nullptr;
    for (const Line& line : lane.turns) {
      if (!may_start(line.client)) continue;
      if (first == nullptr || Used(line) < Used(*first)) first = &line;
    }
    if (first != nullptr) return *first->numbers.begin();
  }
  return std::nullopt;
}

bool JobQueue::HasUsedMost(const std::string& client) const {
  const Duration used = accounts_.at(client).used;
  return std::ranges::all_of(accounts_, [used](const auto& account) {
    return account.second.used <= used;
  });
}

std::optional<uint64_t> JobQueue::Oldest(
    absl::FunctionRef<bool(Job&)> can_start) {
  for (auto& [number, waiting] : jobs_) {
    if (can_start(waiting.job)) return number;
  }
  return std::nullopt;
}

WaitingJob JobQueue::Start() {
  const size_t urgent = MostUrgent();
  const size_t next = NextLane();
  Lane& lane = lanes_[next];
  const auto first = First(lane);
  const uint64_t number = *first->numbers.begin();
  // The client's line goes to the end, and is dropped with its last job.
  lane.turns.splice(lane.turns.end(), lane.turns, first);
  WaitingJob started = StartOutOfTurn(number);

  bool passed = false;
  for (size_t other = next + 1; other < kStoreLane; ++other) {
    if (lanes_[other].turns.empty()) continue;
    ++lanes_[other].passed_over;
    passed = true;
  }
  lane.passed_over = 0;
  passes_ = next == urgent && passed ? passes_ + 1 : 0;
  last_lane_ = next;
  return started;
}

std::optional<WaitingJob> JobQueue::Remove(uint64_t number) {
  if (!jobs_.contains(number)) return std::nullopt;
  WaitingJob waiting = Take(number);
  Close(waiting.job.client);
  return waiting;
}

WaitingJob JobQueue::StartOutOfTurn(uint64_t number) {
  WaitingJob started = Take(number);
  ++accounts_.at(started.job.client).running;
  return started;
}

WaitingJob JobQueue::Take(uint64_t number) {
  const auto it = jobs_.find(number);
  WaitingJob waiting = std::move(it->second);
  jobs_.erase(it);
  Leave(number, waiting.job);
  if (!waiting.job.is_continuation) Release(waiting.job.client);
  return waiting;
}

void JobQueue::Expedite(uint64_t number, JobPriority priority) {
  const auto it = jobs_.find(number);
  if (it == jobs_.end() || it->second.job.priority <= priority) return;
  Leave(number, it->second.job);
  it->second.job.priority = priority;
  Enter(number, it->second.job);
}

std::vector<WaitingJob> JobQueue::Clear() {
  std::vector<WaitingJob> all;
  all.reserve(jobs_.size());
  while (!jobs_.empty()) all.push_back(*Remove(jobs_.begin()->first));
  return all;
}

void JobQueue::Hold(const std::string& client) {
  ++places_;
  ++clients_[client];
}

void JobQueue::Release(const std::string& client) {
  --places_;
  const auto it = clients_.find(client);
  if (--it->second == 0) clients_.erase(it);
}

size_t JobQueue::places_of(const std::string& client) const {
  const auto it = clients_.find(client);
  return it == clients_.end() ? 0 : it->second;
}

void JobQueue::Enter(uint64_t number, const Job& job) {
  Lane& lane = LaneOf(job.priority);
  const auto [it, is_new] = lane.lines.try_emplace(job.client);
  if (is_new) {
    it->second = lane.turns.insert(lane.turns.end(), Line{job.client, {}});
  }
  it->second->numbers.insert(number);
}

void JobQueue::Leave(uint64_t number, const Job& job) {
  Lane& lane = LaneOf(job.priority);
  const auto line = lane.lines.find(job.client);
  line->second->numbers.erase(number);
  if (!line->second->numbers.empty()) return;
  lane.turns.erase(line->second);
  lane.lines.erase(line);
  if (lane.turns.empty()) lane.passed_over = 0;
}

}  // namespace geodesic::server
