#include "solver/thread_team.h"

#include <system_error>

namespace geodesic {
namespace {

// Of the gate: the call's number is above.
constexpr uint64_t kClosed = uint64_t{1} << 31;
constexpr uint64_t kInside = kClosed - 1;

// Some hundred microseconds: what one thread does alone between two calls takes
// some tens, and waking a sleeping one as long.
constexpr int kSpins = 4000;

void Pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

// Returns the value once it is no longer `old`.
template <typename Number>
Number AwaitChange(const std::atomic<Number>& value, Number old) {
  for (int i = 0; i < kSpins; ++i) {
    const Number now = value.load(std::memory_order_acquire);
    if (now != old) return now;
    Pause();
  }
  value.wait(old, std::memory_order_acquire);
  return value.load(std::memory_order_acquire);
}

}  // namespace

ThreadTeam::ThreadTeam(uint32_t size) {
  threads_.reserve(size - 1);
  for (uint32_t member = 1; member < size; ++member) {
    try {
      threads_.emplace_back([this, member] { Serve(member); });
    } catch (const std::system_error&) {
      return;  // the system has no more threads
    }
  }
}

ThreadTeam::~ThreadTeam() {
  is_over_.store(true, std::memory_order_relaxed);
  calls_.fetch_add(1, std::memory_order_release);
  calls_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadTeam::Run(Call call, const void* work) {
  call_ = call;
  work_ = work;
  const uint32_t number = calls_.load(std::memory_order_relaxed) + 1;
  gate_.store(uint64_t{number} << 32, std::memory_order_release);
  calls_.store(number, std::memory_order_release);
  calls_.notify_all();
  call(work, 0);
  uint64_t gate = gate_.fetch_or(kClosed, std::memory_order_acq_rel) | kClosed;
  while (gate & kInside) gate = AwaitChange(gate_, gate);
}

void ThreadTeam::Serve(uint32_t member) {
  for (uint32_t served = 0;;) {
    served = AwaitChange(calls_, served);
    if (is_over_.load(std::memory_order_relaxed)) return;
    if (!Enter(served)) continue;
    call_(work_, member);
    Leave();
  }
}

bool ThreadTeam::Enter(uint32_t call) {
  uint64_t gate = gate_.load(std::memory_order_relaxed);
  while (gate >> 32 == call && !(gate & kClosed)) {
    if (gate_.compare_exchange_weak(gate, gate + 1, std::memory_order_acquire,
                                    std::memory_order_relaxed)) {
      return true;
    }
  }
  return false;
}

void ThreadTeam::Leave() {
  const uint64_t gate = gate_.fetch_sub(1, std::memory_order_release) - 1;
  if ((gate & kClosed) && !(gate & kInside)) gate_.notify_one();
}

}  // namespace geodesic
