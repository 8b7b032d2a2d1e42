#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "solver/queues/binary_heap.h"
#include "solver/queues/fifo.h"
#include "solver/queues/fwp_buckets.h"
#include "solver/queues/label_correcting.h"

namespace geodesic {
namespace {

using ::testing::ElementsAre;

template <WindowQueue Queue>
std::vector<uint32_t> Drain(Queue& queue) {
  std::vector<uint32_t> ids;
  for (uint32_t id = queue.Pop(); id != kNothing; id = queue.Pop()) {
    ids.push_back(id);
  }
  return ids;
}

template <typename Queue>
class QueueTest : public ::testing::Test {};
using Queues = ::testing::Types<BinaryHeap, Fifo, FwpBuckets, LabelCorrecting>;
TYPED_TEST_SUITE(QueueTest, Queues);

// A wavefront in small: children with labels above their parents'.
TYPED_TEST(QueueTest, LosesNothingAndBoundsWhatIsPending) {
  TypeParam queue({.bucket_width = 0.01, .max_batch = 50});
  std::mt19937 random(5);
  // Now and then far ahead, beyond the reach of any ring of buckets.
  const auto step = [&] {
    const double unit = static_cast<double>(random()) / random.max();
    return random() % 50 == 0 ? 1000 * unit : unit;
  };
  std::vector<double> labels;
  std::vector<bool> pending;
  const auto push = [&](double label) {
    queue.Push(static_cast<uint32_t>(labels.size()), label);
    labels.push_back(label);
    pending.push_back(true);
  };
  for (int i = 0; i < 20; ++i) push(step());
  size_t popped = 0;
  double settled = 0;
  for (uint32_t id = queue.Pop(); id != kNothing; id = queue.Pop()) {
    ASSERT_TRUE(pending[id]);
    pending[id] = false;
    ++popped;
    ASSERT_GE(queue.SettledRadius(), settled);
    settled = queue.SettledRadius();
    for (int child = 0; child < 2 && labels.size() < 3000; ++child) {
      push(labels[id] + step());
    }
    if (popped % 64 == 0) {
      for (size_t i = 0; i < labels.size(); ++i) {
        if (pending[i]) {
          ASSERT_GE(labels[i], settled * (1 - 1e-15));
        }
      }
      ASSERT_EQ(queue.size(), labels.size() - popped);
    }
  }
  EXPECT_EQ(popped, labels.size());
  EXPECT_EQ(queue.size(), 0u);
}

TEST(BinaryHeapTest, PopsByLabelThenById) {
  BinaryHeap queue({});
  queue.Push(4, 2);
  queue.Push(3, 1);
  queue.Push(2, 2);
  queue.Push(1, 3);
  EXPECT_THAT(Drain(queue), ElementsAre(3, 2, 4, 1));
  EXPECT_EQ(queue.iterations(), 4u);
}

TEST(FifoTest, PopsInOrderOfBirthRoundByRound) {
  Fifo queue({});
  queue.Push(4, 2);
  queue.Push(3, 1);
  EXPECT_EQ(queue.Pop(), 4u);
  queue.Push(2, 5);
  EXPECT_EQ(queue.SettledRadius(), 1);  // of the round: 3 is still in it
  EXPECT_THAT(Drain(queue), ElementsAre(3, 2));
  EXPECT_EQ(queue.SettledRadius(), 5);
  EXPECT_EQ(queue.iterations(), 2u);
}

// Seeds 0, 4 and 8: the threshold goes to (0 + mean 4) / 2 = 2, so only the
// least enters the deque.
TEST(LabelCorrectingTest, LabelsAboveTheThresholdWait) {
  LabelCorrecting queue({});
  queue.Push(0, 0);
  queue.Push(1, 4);
  queue.Push(2, 8);
  EXPECT_EQ(queue.Pop(), 0u);
  queue.Push(3, 2.5);  // above the threshold: waits with 1 and 2
  queue.Push(4, 1.5);
  EXPECT_EQ(queue.Pop(), 4u);
  EXPECT_EQ(queue.SettledRadius(), 0);
  // Threshold between 2.5 and the mean of 2.5, 4 and 8.
  EXPECT_EQ(queue.Pop(), 3u);
  EXPECT_EQ(queue.SettledRadius(), 2.5);
  EXPECT_EQ(queue.iterations(), 2u);
}

TEST(LabelCorrectingTest, SmallLabelsGoFirstAndLargeOnesLast) {
  LabelCorrecting queue({});
  for (uint32_t id = 0; id < 6; ++id) queue.Push(id, 10);
  queue.Push(6, 20);
  EXPECT_EQ(queue.Pop(), 0u);  // threshold (10 + 80 / 7) / 2: all but 6 enter
  queue.Push(7, 10.2);         // at the back
  queue.Push(8, 10);           // not smaller than the first: behind 7
  for (uint32_t id = 1; id < 6; ++id) EXPECT_EQ(queue.Pop(), id);
  queue.Push(9, 10.05);  // smaller than 7, the first: at the front
  EXPECT_EQ(queue.Pop(), 9u);
  EXPECT_EQ(queue.Pop(), 8u);  // 7 is above the mean of 7 and 8, and goes last
  EXPECT_EQ(queue.Pop(), 7u);
  EXPECT_EQ(queue.Pop(), 6u);
}

TEST(LabelCorrectingTest, EqualLabelsEnd) {
  LabelCorrecting queue({});
  for (uint32_t id = 0; id < 1000; ++id) queue.Push(id, 0.1);
  EXPECT_EQ(Drain(queue).size(), 1000u);
}

TEST(FwpBucketsTest, FirstInFirstOutWithinABucket) {
  FwpBuckets queue({.bucket_width = 1});
  queue.Push(5, 0.9);
  queue.Push(4, 0.1);
  queue.Push(3, 0.5);
  EXPECT_THAT(Drain(queue), ElementsAre(5, 4, 3));
  EXPECT_EQ(queue.iterations(), 1u);
}

TEST(FwpBucketsTest, WindowsBornInAnIterationWaitForTheNext) {
  FwpBuckets queue({.bucket_width = 1});
  queue.Push(0, 0.5);
  queue.Push(1, 1.5);
  EXPECT_EQ(queue.Pop(), 0u);  // K is the whole seed front: both are taken
  EXPECT_EQ(queue.Upcoming(1), 1u);
  queue.Push(2, 0.6);  // same bucket as 0, but born now
  EXPECT_EQ(queue.Pop(), 1u);
  EXPECT_EQ(queue.iterations(), 1u);
  EXPECT_EQ(queue.Pop(), 2u);
  EXPECT_EQ(queue.iterations(), 2u);
}

// K grows by the windows born beyond the iteration's buckets less those born
// within: K_{i+1} = K_i + (c_large - c_small).
TEST(FwpBucketsTest, AdaptsTheBatch) {
  FwpBuckets queue({.bucket_width = 1});
  queue.Push(0, 0.5);  // K = 1
  EXPECT_EQ(queue.Pop(), 0u);
  // Two far, one near: K becomes 2.
  queue.Push(1, 0.6);
  queue.Push(2, 1.5);
  queue.Push(3, 2.5);
  EXPECT_EQ(queue.Pop(), 1u);
  EXPECT_EQ(queue.Upcoming(1), 2u);
  EXPECT_EQ(queue.Upcoming(2), kNothing);  // 3 is not of this iteration
}

// A fixed K takes as many windows in every iteration, by whole buckets.
TEST(FwpBucketsTest, FixedBatch) {
  FwpBuckets queue(
      {.bucket_width = 1, .max_batch = 2, .adaptive_batch = false});
  for (uint32_t id = 0; id < 5; ++id) queue.Push(id, id + 0.5);
  EXPECT_EQ(queue.Pop(), 0u);
  EXPECT_EQ(queue.least(), 2);
  EXPECT_EQ(queue.Upcoming(1), 1u);
  EXPECT_EQ(queue.Upcoming(2), kNothing);
  EXPECT_THAT(Drain(queue), ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(queue.iterations(), 3u);
}

// A fixed K of one: a bucket is left when nothing is in it any more.
TEST(FwpBucketsTest, FixedBatchOfOneDrainsBuckets) {
  FwpBuckets queue(
      {.bucket_width = 1, .max_batch = 1, .adaptive_batch = false});
  queue.Push(0, 0.5);
  queue.Push(1, 0.6);
  queue.Push(2, 1.5);
  EXPECT_EQ(queue.Pop(), 0u);
  queue.Push(3, 0.7);
  queue.Push(4, 1.1);
  EXPECT_THAT(Drain(queue), ElementsAre(1, 3, 2, 4));
}

TEST(FwpBucketsTest, LabelsThatRoundBackwardsStayInTheCurrentBucket) {
  FwpBuckets queue({.bucket_width = 1});
  queue.Push(0, 7.0);
  EXPECT_EQ(queue.Pop(), 0u);
  queue.Push(1, 6.999);
  EXPECT_EQ(queue.Pop(), 1u);
  EXPECT_EQ(queue.SettledRadius(), 7.0);
}

TEST(FwpBucketsTest, EnormousLabelsAreOrderedToo) {
  FwpBuckets queue({.bucket_width = 1e-6, .max_batch = 1});
  queue.Push(0, 1e300);
  queue.Push(1, 1e9);
  queue.Push(2, 1e-3);
  EXPECT_THAT(Drain(queue), ElementsAre(2, 1, 0));
}

}  // namespace
}  // namespace geodesic
