// The scheduler on real threads: whatever comes between submitting, cancelling,
// expediting and waiting for memory, every job runs that nobody cancelled, and
// all memory comes back.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "absl/strings/str_cat.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/jobs/thread_pool.h"
#include "tests/support/random.h"

namespace geodesic::server {
namespace {

constexpr JobPriority kPriorities[] = {JobPriority::kBuild, JobPriority::kSolve,
                                       JobPriority::kRow, JobPriority::kBatch};

class SchedulerThreadsTest : public ::testing::Test {
 protected:
  static constexpr int kJobs = 500;  // of each client

  // A job that needs up to all of the memory.
  Job MakeJob(geodesic::test::Random& random, const std::string& client) {
    const uint64_t bytes = 1 + random.Below(100);
    auto held = std::make_shared<ByteReservation>();
    return {.priority = kPriorities[random.Below(4)],
            .client = client,
            .reserve = [this, bytes, held]() -> absl::Status {
              auto taken = ByteReservation::Make(memory_, bytes);
              if (!taken.ok()) return taken.status();
              *held = *std::move(taken);
              return absl::OkStatus();
            },
            .run =
                [this, bytes, held](std::stop_token) {
                  EXPECT_EQ(held->bytes(), bytes);
                  EXPECT_LE(memory_->used(), 100);
                  ++ran_;
                },
            .abandon = [this](const absl::Status&) { ++abandoned_; }};
  }

  // One client's part; returns how many jobs it cancelled.
  int Submit(int number) {
    geodesic::test::Random random(number);
    const std::string client = absl::StrCat("client:", number);
    int cancelled = 0;
    for (int i = 0; i < kJobs; ++i) {
      const auto job = scheduler_.Submit(MakeJob(random, client));
      EXPECT_TRUE(job.ok()) << job.status();
      switch (random.Below(4)) {
        case 0:
          scheduler_.Cancel(*job);
          ++cancelled;
          break;
        case 1:
          scheduler_.Expedite(*job, JobPriority::kBuild);
          break;
        default:
          break;
      }
    }
    return cancelled;
  }

  std::shared_ptr<ByteBudget> memory_ =
      std::make_shared<ByteBudget>("solver memory", 100);
  std::atomic<int> ran_ = 0;
  std::atomic<int> abandoned_ = 0;
  ThreadPool pool_{4};
  Scheduler scheduler_{pool_, /*max_running=*/4, /*max_queued=*/10'000};
};

TEST_F(SchedulerThreadsTest, EveryJobRunsAndAllMemoryComesBack) {
  std::atomic<int> cancelled = 0;
  {
    std::vector<std::jthread> clients;
    for (int number = 0; number < 4; ++number) {
      clients.emplace_back([&, number] { cancelled += Submit(number); });
    }
  }
  // Long enough for whoever is not stuck.
  ASSERT_TRUE(scheduler_.WaitIdle(std::chrono::minutes(2)));
  EXPECT_GE(ran_, 4 * kJobs - cancelled);
  EXPECT_LE(ran_, 4 * kJobs);
  // What others hold comes back when they end, so nobody is turned away.
  EXPECT_EQ(abandoned_, 0);
  EXPECT_EQ(memory_->used(), 0);
}

TEST_F(SchedulerThreadsTest, StoppingLeavesNobodyWaiting) {
  std::jthread client([&] {
    geodesic::test::Random random(1);
    for (int i = 0; i < kJobs; ++i) {
      if (!scheduler_.Submit(MakeJob(random, "client:a")).ok()) ++abandoned_;
    }
  });
  while (ran_ == 0) std::this_thread::yield();
  scheduler_.StopAll();
  client.join();
  ASSERT_TRUE(scheduler_.WaitIdle(std::chrono::minutes(2)));
  EXPECT_EQ(ran_ + abandoned_, kJobs);
  EXPECT_EQ(memory_->used(), 0);
}

}  // namespace
}  // namespace geodesic::server
