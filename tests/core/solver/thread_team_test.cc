#include "thread_team.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <vector>

namespace geodesic {
namespace {

TEST(ThreadTeamTest, EveryMemberWorksOnceACall) {
  for (const uint32_t size : {1u, 2u, 5u}) {
    ThreadTeam team(size);
    EXPECT_EQ(team.size(), size);
    std::vector<uint32_t> calls(size);
    for (uint32_t call = 1; call <= 1000; ++call) {
      team.Run([&](uint32_t member) { ++calls[member]; });
      // Not atomic: the team's return is what makes it visible.
      ASSERT_EQ(calls, std::vector<uint32_t>(size, call));
    }
  }
}

TEST(ThreadTeamTest, MembersSeeWhatWasWrittenBefore) {
  ThreadTeam team(3);
  std::vector<uint64_t> numbers(300), sums(3);
  for (uint64_t call = 0; call < 200; ++call) {
    std::iota(numbers.begin(), numbers.end(), call);
    team.Run([&](uint32_t member) {
      sums[member] =
          std::accumulate(numbers.begin() + 100 * member,
                          numbers.begin() + 100 * (member + 1), uint64_t{0});
    });
    ASSERT_EQ(sums[0] + sums[1] + sums[2], 300 * call + 299 * 300 / 2);
  }
}

}  // namespace
}  // namespace geodesic
