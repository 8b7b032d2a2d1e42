#include "thread_team.h"

namespace geodesic {
namespace {

// Some ten microseconds: waking a sleeping thread takes longer.
constexpr int kSpins = 2000;

void Pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

// Until `value` is no longer `old`.
void AwaitChange(const std::atomic<uint32_t>& value, uint32_t old) {
  for (int i = 0; i < kSpins; ++i) {
    if (value.load(std::memory_order_acquire) != old) return;
    Pause();
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

ThreadTeam::ThreadTeam(uint32_t size) {
  threads_.reserve(size - 1);
  for (uint32_t member = 1; member < size; ++member) {
    threads_.emplace_back([this, member] { Serve(member); });
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
  working_.store(size() - 1, std::memory_order_relaxed);
  calls_.fetch_add(1, std::memory_order_release);
  calls_.notify_all();
  call(work, 0);
  while (const uint32_t left = working_.load(std::memory_order_acquire)) {
    AwaitChange(working_, left);
  }
}

void ThreadTeam::Serve(uint32_t member) {
  for (uint32_t served = 0;; ++served) {
    AwaitChange(calls_, served);
    if (is_over_.load(std::memory_order_relaxed)) return;
    call_(work_, member);
    working_.fetch_sub(1, std::memory_order_acq_rel);
    working_.notify_one();
  }
}

}  // namespace geodesic
