#include "server/engine/jobs/row_pipeline.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "tests/engine/fakes.h"

namespace geodesic::server {
namespace {

class RowPipelineTest : public ::testing::Test {
 protected:
  ~RowPipelineTest() override {
    scheduler_.StopAll();
    executor_.RunAll();
  }

  std::shared_ptr<RowPipeline> Make(uint64_t rows,
                                    TimePoint deadline = kNoDeadline,
                                    uint64_t first_row = 0) {
    return std::make_shared<RowPipeline>(
        jobs_, scheduler_,
        RowJobs{.deadline = deadline,
                .first_row = first_row,
                .planned_bytes = kPlannedBytes,
                .row_bytes = kRowBytes},
        rows,
        [this](uint64_t row, Checkpoint& checkpoint,
               ByteReservation memory) -> absl::StatusOr<AnswerRow> {
          started_.push_back(row);
          EXPECT_EQ(memory.bytes(), kRowBytes);
          EXPECT_EQ(memory_->used(), kPlannedBytes + kRowBytes);
          absl::Status status = checkpoint.Poll({.windows_propagated = 10});
          if (status.ok() && row == bad_row_) {
            status = absl::InternalError("bad row");
          }
          if (!status.ok()) return status;
          return AnswerRow{{.values = {static_cast<double>(row)}}, {}};
        },
        [calls = calls_] { ++*calls; });
  }

  static constexpr uint64_t kPlannedBytes = 1000;
  static constexpr uint64_t kRowBytes = 100;

  test::FakeClock clock_;
  test::ManualExecutor executor_;
  std::shared_ptr<ByteBudget> memory_ =
      std::make_shared<ByteBudget>("solver memory", 1 << 20);
  std::vector<uint64_t> started_;
  uint64_t bad_row_ = 1000;
  std::shared_ptr<int> calls_ = std::make_shared<int>(0);  // of on_row
  Scheduler scheduler_{executor_, /*max_running=*/2, /*max_queued=*/2};
  SoloJobs jobs_{clock_, scheduler_, memory_, std::chrono::milliseconds(50)};
};

TEST_F(RowPipelineTest, IsAheadByOneRowMoreThanThereAreThreads) {
  const auto rows = Make(10);
  ASSERT_TRUE(rows->Start().ok());
  executor_.RunAll();
  EXPECT_EQ(started_, (std::vector<uint64_t>{0, 1, 2}));
  EXPECT_EQ(rows->rows_finished(), 3);
  // One taken, one more computed.
  const auto first = rows->Take();
  ASSERT_TRUE(first.has_value() && first->ok());
  EXPECT_EQ((*first)->values, std::vector<double>{0});
  executor_.RunAll();
  EXPECT_EQ(started_.size(), 4);
}

TEST_F(RowPipelineTest, HandsRowsOutInOrderToTheLast) {
  const auto rows = Make(7);
  ASSERT_TRUE(rows->Start().ok());
  EXPECT_FALSE(rows->Take().has_value());
  for (int row = 0; row < 7; ++row) {
    executor_.RunAll();
    auto next = rows->Take();
    ASSERT_TRUE(next.has_value() && next->ok());
    EXPECT_EQ((*next)->values, std::vector<double>{double(row)});
  }
  executor_.RunAll();
  EXPECT_EQ(*calls_, 7);
  EXPECT_EQ(rows->windows_propagated(), 70);
  // The pipeline holds those who wait no longer than it needs to.
  EXPECT_EQ(calls_.use_count(), 1);
}

TEST_F(RowPipelineTest, BeginsWithTheFirstRowThatIsWanted) {
  const auto rows = Make(7, kNoDeadline, /*first_row=*/5);
  ASSERT_TRUE(rows->Start().ok());
  executor_.RunAll();
  EXPECT_EQ(started_, (std::vector<uint64_t>{5, 6}));
  EXPECT_EQ(rows->rows_finished(), 7);
  for (int row = 5; row < 7; ++row) {
    auto next = rows->Take();
    ASSERT_TRUE(next.has_value() && next->ok());
    EXPECT_EQ((*next)->values, std::vector<double>{double(row)});
  }
  EXPECT_EQ(calls_.use_count(), 1);
}

TEST_F(RowPipelineTest, AFullQueueRefusesTheFirstRowAndNoOther) {
  std::vector<std::shared_ptr<RowPipeline>> open;  // two run, two wait
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(open.emplace_back(Make(10))->Start().ok());
  }
  EXPECT_TRUE(absl::IsResourceExhausted(Make(10)->Start()));
  for (int row = 0; row < 10; ++row) {
    executor_.RunAll();
    for (const auto& pipeline : open) {
      const auto next = pipeline->Take();
      EXPECT_TRUE(next.has_value() && next->ok());
    }
  }
}

TEST_F(RowPipelineTest, DrainingLetsAMatrixFinish) {
  const auto rows = Make(6);
  ASSERT_TRUE(rows->Start().ok());
  scheduler_.BeginDrain();
  EXPECT_TRUE(absl::IsUnavailable(Make(1)->Start()));
  for (int row = 0; row < 6; ++row) {
    executor_.RunAll();
    const auto next = rows->Take();
    EXPECT_TRUE(next.has_value() && next->ok());
  }
}

TEST_F(RowPipelineTest, StoppingFailsIt) {
  const auto rows = Make(6);
  ASSERT_TRUE(rows->Start().ok());
  scheduler_.StopAll();
  executor_.RunAll();
  const auto next = rows->Take();
  ASSERT_TRUE(next.has_value());
  EXPECT_TRUE(absl::IsUnavailable(next->status()));
}

TEST_F(RowPipelineTest, AFailureEndsIt) {
  bad_row_ = 1;
  const auto rows = Make(10);
  ASSERT_TRUE(rows->Start().ok());
  executor_.RunAll();
  auto next = rows->Take();
  ASSERT_TRUE(next.has_value() && next->ok());
  next = rows->Take();
  ASSERT_TRUE(next.has_value());
  EXPECT_TRUE(absl::IsInternal(next->status()));
  executor_.RunAll();
  EXPECT_EQ(started_.size(), 3);
}

TEST_F(RowPipelineTest, CancellingDropsWhatWaits) {
  const auto rows = Make(10);
  ASSERT_TRUE(rows->Start().ok());
  rows->Cancel();
  EXPECT_EQ(scheduler_.queued(), 0);
  executor_.RunAll();
  EXPECT_TRUE(started_.empty());
  EXPECT_EQ(*calls_, 0);
  EXPECT_EQ(calls_.use_count(), 1);
}

// Though their readers leave them standing.
TEST_F(RowPipelineTest, ThoseWithNoRowToComeTakeNoPlace) {
  std::vector<std::shared_ptr<RowPipeline>> open;
  const auto start = [&](uint64_t rows) {
    ASSERT_TRUE(open.emplace_back(Make(rows))->Start().ok());
    executor_.RunAll();
  };
  for (int i = 0; i < 5; ++i) {
    bad_row_ = 1;
    start(10);
    bad_row_ = 1000;
    start(2);
    start(10);
    open.back()->Cancel();
  }
}

TEST_F(RowPipelineTest, ARowIsChargedForWhatItTakes) {
  const auto charge = [&](size_t values) {
    return Charge(DistanceRow{.values = std::vector<double>(values)},
                  *ByteReservation::Make(memory_, kRowBytes));
  };
  for (const size_t values : {1, 1000}) {
    const absl::StatusOr<AnswerRow> row = charge(values);
    ASSERT_TRUE(row.ok()) << row.status();
    EXPECT_EQ(memory_->used(), values * sizeof(double));
  }
  EXPECT_TRUE(absl::IsResourceExhausted(charge(1 << 20).status()));
}

TEST_F(RowPipelineTest, DeadlinesHoldForEveryRow) {
  const auto rows = Make(10, clock_.Now() + std::chrono::seconds(1));
  ASSERT_TRUE(rows->Start().ok());
  executor_.RunAll();
  ASSERT_TRUE(rows->Take()->ok());
  clock_.Advance(std::chrono::seconds(1));
  executor_.RunAll();
  ASSERT_TRUE(rows->Take()->ok());
  ASSERT_TRUE(rows->Take()->ok());
  EXPECT_TRUE(absl::IsDeadlineExceeded(rows->Take()->status()));
}

}  // namespace
}  // namespace geodesic::server
