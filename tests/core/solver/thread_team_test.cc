#include "solver/thread_team.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <numeric>
#include <vector>

namespace geodesic {
namespace {

TEST(ThreadTeamTest, TheCallerAlwaysWorksAndTheOthersAtMostOnceACall) {
  for (const uint32_t size : {1u, 2u, 5u}) {
    ThreadTeam team(size);
    EXPECT_EQ(team.size(), size);
    std::vector<uint32_t> calls(size);
    for (uint32_t call = 1; call <= 1000; ++call) {
      const std::vector<uint32_t> before = calls;
      team.Run([&](uint32_t member) { ++calls[member]; });
      // Not atomic: the return is what makes it visible.
      ASSERT_EQ(calls[0], call);
      for (uint32_t member = 1; member < size; ++member) {
        ASSERT_LE(calls[member], before[member] + 1);
      }
    }
  }
}

// As a user that may have no more threads than there are.
void WorkWithoutMoreThreads() {
  constexpr rlimit kNone = {1, 1};
  if (setrlimit(RLIMIT_NPROC, &kNone) != 0) _exit(2);
  // The limit does not hold for the first user.
  if (geteuid() == 0 && setuid(65534) != 0) _exit(3);
  uint32_t calls = 0;
  ThreadTeam team(4);
  team.Run([&](uint32_t) { ++calls; });
  _exit(team.size() == 1 && calls == 1 ? 0 : 1);
}

TEST(ThreadTeamTest, IsSmallerWhereTheSystemHasNoMoreThreads) {
  EXPECT_EXIT(WorkWithoutMoreThreads(), ::testing::ExitedWithCode(0), "");
}

TEST(ThreadTeamTest, EveryMemberComesIfThereIsTime) {
  ThreadTeam team(4);
  for (int call = 0; call < 50; ++call) {
    std::atomic<uint32_t> present = 0;
    team.Run([&](uint32_t) {
      ++present;
      present.notify_all();
      for (uint32_t now = present; now < 4; now = present) present.wait(now);
    });
    ASSERT_EQ(present, 4u);
  }
}

TEST(ThreadTeamTest, WhatIsWrittenBeforeIsSeenAndWhatIsDoneIsSeenAfter) {
  constexpr size_t kParts = 30;
  ThreadTeam team(3);
  std::vector<uint64_t> numbers(100 * kParts), sums(kParts);
  for (uint64_t call = 0; call < 300; ++call) {
    std::iota(numbers.begin(), numbers.end(), call);
    std::atomic<size_t> next = 0;
    team.Run([&](uint32_t) {
      for (size_t part = next++; part < kParts; part = next++) {
        const auto begin = numbers.begin() + static_cast<int64_t>(100 * part);
        sums[part] = std::accumulate(begin, begin + 100, uint64_t{0});
      }
    });
    const uint64_t n = numbers.size();
    ASSERT_EQ(std::accumulate(sums.begin(), sums.end(), uint64_t{0}),
              n * call + n * (n - 1) / 2);
  }
}

}  // namespace
}  // namespace geodesic
