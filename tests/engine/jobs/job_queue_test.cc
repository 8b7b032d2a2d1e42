#include "server/engine/jobs/job_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/support/random.h"

namespace geodesic::server {
namespace {

using Numbers = std::vector<uint64_t>;

class JobQueueTest : public ::testing::Test {
 protected:
  uint64_t Push(JobPriority priority, const std::string& client = "a") {
    const uint64_t number = next_number_++;
    queue_.Push(number, {.job = {.priority = priority, .client = client}});
    return number;
  }

  // Starts everything.
  Numbers StartAll() {
    Numbers order;
    while (!queue_.empty()) {
      order.push_back(queue_.Next());
      queue_.Start();
    }
    return order;
  }

  JobQueue queue_;
  uint64_t next_number_ = 0;
};

TEST_F(JobQueueTest, UrgentJobsGoFirst) {
  for (const JobPriority priority :
       {JobPriority::kPrepare, JobPriority::kStore, JobPriority::kBatch,
        JobPriority::kRow, JobPriority::kSolve, JobPriority::kBuild}) {
    Push(priority);
  }
  EXPECT_EQ(StartAll(), (Numbers{5, 4, 3, 2, 1, 0}));
}

TEST_F(JobQueueTest, ClientsTakeTurns) {
  for (int i = 0; i < 4; ++i) Push(JobPriority::kSolve, "many");  // 0 to 3
  Push(JobPriority::kSolve, "one");                               // 4
  Push(JobPriority::kSolve, "two");                               // 5
  Push(JobPriority::kSolve, "two");                               // 6
  EXPECT_EQ(StartAll(), (Numbers{0, 4, 5, 1, 6, 2, 3}));
}

TEST_F(JobQueueTest, WhoseJobsRunWaitsForThem) {
  const uint64_t first = Push(JobPriority::kSolve, "many");
  EXPECT_EQ(queue_.NextWithin(1), first);
  const uint64_t second = Push(JobPriority::kSolve, "many");
  queue_.StartOutOfTurn(first);
  EXPECT_EQ(queue_.NextWithin(1), std::nullopt);
  EXPECT_EQ(queue_.NextWithin(2), second);
  const uint64_t row = Push(JobPriority::kRow, "few");
  EXPECT_EQ(queue_.NextWithin(1), row);
  EXPECT_EQ(queue_.NextWithin(2), second);
  const uint64_t solve = Push(JobPriority::kSolve, "few");
  EXPECT_EQ(queue_.NextWithin(1), solve) << "the more urgent first";
  queue_.StartOutOfTurn(solve);
  EXPECT_EQ(queue_.NextWithin(1), std::nullopt) << "one of each runs";
  queue_.Done("few", {});
  EXPECT_EQ(queue_.NextWithin(1), row);
}

// A long row of one client is not worth a short one of another.
TEST_F(JobQueueTest, WhoHasUsedLessGoesFirst) {
  using std::chrono::milliseconds;
  for (int i = 0; i < 3; ++i) Push(JobPriority::kRow, "long");  // 0 to 2
  EXPECT_EQ(queue_.Next(), 0);
  queue_.Start();
  for (int i = 0; i < 3; ++i) Push(JobPriority::kRow, "short");  // 3 to 5
  queue_.Done("long", milliseconds(300));
  for (const uint64_t number : {3, 4, 5}) {
    EXPECT_EQ(queue_.Next(), number);
    queue_.Start();
    queue_.Done("short", milliseconds(2));
  }
  // Who comes later has used no less than the others.
  Push(JobPriority::kRow, "late");  // 6
  EXPECT_EQ(queue_.Next(), 1);
  queue_.Start();
  queue_.Done("long", milliseconds(300));
  EXPECT_EQ(StartAll(), (Numbers{6, 2}));
}

// Also where the one whose turn it is has enough that run.
TEST_F(JobQueueTest, OfThoseWhoMayStartWhoHasUsedLessGoesFirst) {
  using std::chrono::milliseconds;
  for (const char* client : {"runs", "long", "short"}) {
    for (int i = 0; i < 2; ++i) Push(JobPriority::kRow, client);
  }
  for (const uint64_t number : {0, 2, 4}) queue_.StartOutOfTurn(number);
  queue_.Done("long", milliseconds(300));
  queue_.Done("short", milliseconds(2));
  EXPECT_EQ(queue_.Next(), 1);
  EXPECT_EQ(queue_.NextWithin(1), 5);
}

TEST_F(JobQueueTest, WhoComesBackStandsBehindTheOthers) {
  Push(JobPriority::kSolve, "many");  // 0
  Push(JobPriority::kSolve, "many");  // 1
  Push(JobPriority::kSolve, "one");   // 2
  queue_.Start();
  queue_.Start();
  Push(JobPriority::kSolve, "one");  // 3
  EXPECT_EQ(StartAll(), (Numbers{1, 3}));
}

TEST_F(JobQueueTest, TurnsOfOneKindAreNotThoseOfAnother) {
  Push(JobPriority::kRow, "a");    // 0
  Push(JobPriority::kRow, "b");    // 1
  Push(JobPriority::kSolve, "a");  // 2
  EXPECT_EQ(StartAll(), (Numbers{2, 0, 1}));
}

TEST_F(JobQueueTest, WhatIsTakenOutIsGone) {
  Push(JobPriority::kSolve, "a");
  const uint64_t middle = Push(JobPriority::kSolve, "a");
  Push(JobPriority::kSolve, "b");
  EXPECT_EQ(queue_.places_of("a"), 2);
  EXPECT_TRUE(queue_.Remove(middle).has_value());
  EXPECT_FALSE(queue_.Remove(middle).has_value());
  EXPECT_EQ(queue_.places_of("a"), 1);
  EXPECT_EQ(queue_.size(), 2);
  EXPECT_TRUE(queue_.Remove(Push(JobPriority::kSolve, "c")).has_value());
  EXPECT_EQ(queue_.clients(), 2);
  EXPECT_EQ(StartAll(), (Numbers{0, 2}));
  EXPECT_EQ(queue_.places_of("a"), 0);
}

TEST_F(JobQueueTest, AJobCanBecomeMoreUrgentButNotLess) {
  Push(JobPriority::kSolve);                         // 0
  const uint64_t batch = Push(JobPriority::kBatch);  // 1
  Push(JobPriority::kSolve);                         // 2
  queue_.Expedite(batch, JobPriority::kSolve);
  queue_.Expedite(2, JobPriority::kStore);
  queue_.Expedite(17, JobPriority::kBuild);  // is not there
  // It goes by its age.
  EXPECT_EQ(StartAll(), (Numbers{0, 1, 2}));
}

// Questions without end, and yet rows and batches get on.
TEST_F(JobQueueTest, OneStartOfNineGoesToWhoWasPassedOver) {
  for (int i = 0; i < 100; ++i) Push(JobPriority::kRow);
  for (int i = 0; i < 100; ++i) Push(JobPriority::kBatch);
  for (int i = 0; i < 100; ++i) Push(JobPriority::kStore);
  std::map<JobPriority, int> started;
  for (int i = 0; i < 180; ++i) {
    Push(JobPriority::kSolve);
    const WaitingJob job = queue_.Start();
    ++started[job.job.priority];
    const bool is_question = job.job.priority == JobPriority::kSolve;
    EXPECT_EQ(is_question, i % 9 != 8) << i;
  }
  EXPECT_EQ(started[JobPriority::kRow], 10);
  EXPECT_EQ(started[JobPriority::kBatch], 10);
  EXPECT_EQ(started[JobPriority::kStore], 0);
}

// The rule that matters to who waits for a question: whatever waits beside it,
// never do two less urgent jobs start before it.
TEST_F(JobQueueTest, AQuestionWaitsForOneLessUrgentJobAtMost) {
  geodesic::test::Random random(7);
  bool waits = false;
  int less_urgent = 0;
  int questions = 0;
  for (int step = 0; step < 100'000; ++step) {
    const uint64_t what = random.Below(8);
    if (what == 0 && !waits) {
      Push(JobPriority::kSolve, "asker");
      waits = true;
      less_urgent = 0;
    } else if (what < 3) {
      Push(JobPriority::kRow, "matrix");
    } else if (what < 5) {
      Push(JobPriority::kBatch, "batch");
    } else if (!queue_.empty()) {
      const WaitingJob job = queue_.Start();
      if (job.job.client == "asker") {
        waits = false;
        ++questions;
      } else if (waits) {
        EXPECT_LE(++less_urgent, 1);
      }
    }
  }
  EXPECT_GT(questions, 1000);
}

}  // namespace
}  // namespace geodesic::server
