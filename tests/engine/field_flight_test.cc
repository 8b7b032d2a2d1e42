#include "server/engine/field_flight.h"

#include <gtest/gtest.h>

#include <memory>

#include "tests/engine/fakes.h"

namespace geodesic::server {
namespace {

using test::RecordingObserver;

FlightKey Key(uint32_t vertex) {
  return {
      .field = {.mesh_digest = "mesh", .sources = {{VertexPoint{vertex}, 0}}}};
}

class FieldFlightTest : public ::testing::Test {
 protected:
  FieldFlights::Seat Join(const std::shared_ptr<RecordingObserver>& observer,
                          TimePoint deadline = kNoDeadline) {
    return flights_.Join(Key(0), {observer, deadline});
  }

  FieldFlights flights_;
  test::FakeClock clock_;
  std::shared_ptr<RecordingObserver> a_ = std::make_shared<RecordingObserver>();
  std::shared_ptr<RecordingObserver> b_ = std::make_shared<RecordingObserver>();
  const FieldHandle field_ = std::make_shared<const DistanceField>();
  const FieldAnswer answer_{.field = field_};
};

TEST_F(FieldFlightTest, EqualQueriesShareAFlight) {
  const auto a = Join(a_);
  const auto b = Join(b_);
  EXPECT_TRUE(a.is_first);
  EXPECT_FALSE(b.is_first);
  EXPECT_EQ(a.flight, b.flight);
  const auto other = flights_.Join(Key(1), {a_});
  EXPECT_TRUE(other.is_first);
  EXPECT_NE(other.flight, a.flight);

  flights_.Complete(*a.flight, answer_);
  EXPECT_EQ(**a_->field, field_);
  EXPECT_EQ(**b_->field, field_);
  EXPECT_EQ(a_->calls, 1);
  flights_.Complete(*other.flight, answer_);
}

TEST_F(FieldFlightTest, ACompletedFlightTakesNobodyOnBoard) {
  const auto a = Join(a_);
  flights_.Complete(*a.flight, answer_);
  const auto b = Join(b_);
  EXPECT_TRUE(b.is_first);
  EXPECT_NE(a.flight, b.flight);
  EXPECT_EQ(flights_.size(), 1);
}

TEST_F(FieldFlightTest, OnlyTheLastToLeaveCallsItOff) {
  const auto a = Join(a_);
  const auto b = Join(b_);
  const Scheduler::JobId job{7};
  flights_.SetJob(*a.flight, job);

  EXPECT_EQ(flights_.Leave(a), std::nullopt);
  EXPECT_TRUE(flights_.Expire(*b.flight, clock_.Now()).ok());
  EXPECT_EQ(flights_.Leave(a), std::nullopt);  // twice is once
  EXPECT_EQ(flights_.Leave(b), job);
  EXPECT_TRUE(absl::IsCancelled(flights_.Expire(*b.flight, clock_.Now())));
  EXPECT_EQ(flights_.size(), 0);
  EXPECT_EQ(a_->calls + b_->calls, 0);
}

TEST_F(FieldFlightTest, NobodyJoinsAFlightThatWasCalledOff) {
  const auto a = Join(a_);
  flights_.Leave(a);
  const auto b = Join(b_);
  EXPECT_TRUE(b.is_first);
  // The end of the old flight does not touch the new one.
  flights_.Complete(*a.flight, absl::CancelledError("called off"));
  EXPECT_EQ(b_->calls, 0);
  EXPECT_EQ(flights_.size(), 1);
  flights_.Complete(*b.flight, answer_);
  EXPECT_TRUE(b_->field->ok());
}

TEST_F(FieldFlightTest, ProgressReachesThoseOnBoard) {
  const auto a = Join(a_);
  const auto b = Join(b_);
  flights_.Publish(*a.flight, {.vertices_reached = 1});
  flights_.Leave(a);
  flights_.Publish(*b.flight, {.vertices_reached = 2});
  ASSERT_EQ(a_->seen.size(), 1);
  ASSERT_EQ(b_->seen.size(), 2);
  EXPECT_EQ(b_->seen[1].vertices_reached, 2);
}

TEST_F(FieldFlightTest, EachWaiterHasItsOwnDeadline) {
  const auto a = Join(a_, clock_.Now() + std::chrono::seconds(1));
  Join(b_, clock_.Now() + std::chrono::seconds(2));

  clock_.Advance(std::chrono::milliseconds(999));
  EXPECT_TRUE(flights_.Expire(*a.flight, clock_.Now()).ok());
  EXPECT_EQ(a_->calls, 0);

  clock_.Advance(std::chrono::milliseconds(1));
  EXPECT_TRUE(flights_.Expire(*a.flight, clock_.Now()).ok());
  EXPECT_TRUE(absl::IsDeadlineExceeded(a_->field->status()));
  EXPECT_EQ(b_->calls, 0);

  clock_.Advance(std::chrono::seconds(1));
  EXPECT_TRUE(
      absl::IsDeadlineExceeded(flights_.Expire(*a.flight, clock_.Now())));
  EXPECT_TRUE(absl::IsDeadlineExceeded(b_->field->status()));
  EXPECT_EQ(a_->calls, 1);
}

TEST_F(FieldFlightTest, ErrorsReachEveryone) {
  const auto a = Join(a_);
  Join(b_);
  flights_.Complete(*a.flight, absl::InternalError("broken"));
  EXPECT_TRUE(absl::IsInternal(a_->field->status()));
  EXPECT_TRUE(absl::IsInternal(b_->field->status()));
}

}  // namespace
}  // namespace geodesic::server
