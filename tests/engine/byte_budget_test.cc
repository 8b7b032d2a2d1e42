#include "server/engine/base/byte_budget.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "server/engine/base/status_details.h"

namespace geodesic::server {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::shared_ptr<ByteBudget> Budget(uint64_t capacity) {
  return std::make_shared<ByteBudget>("test memory", capacity);
}

TEST(ByteBudget, ReservationsComeAndGo) {
  const auto budget = Budget(100);
  {
    auto first = ByteReservation::Make(budget, 60);
    ASSERT_TRUE(first.ok());
    auto second = ByteReservation::Make(budget, 40);
    ASSERT_TRUE(second.ok());
    EXPECT_EQ(budget->used(), 100);
    EXPECT_FALSE(ByteReservation::Make(budget, 1).ok());
  }
  EXPECT_EQ(budget->used(), 0);
}

TEST(ByteBudget, WaitingHelpsWhenTheNeedFitsAnIdleServer) {
  const auto budget = Budget(100);
  const auto held = ByteReservation::Make(budget, 80);
  const absl::Status status = ByteReservation::Make(budget, 30).status();
  EXPECT_TRUE(absl::IsResourceExhausted(status));
  EXPECT_THAT(std::string(status.message()),
              AllOf(HasSubstr("test memory"), HasSubstr("100"), HasSubstr("30"),
                    HasSubstr("80")));
  EXPECT_TRUE(RetryAfter(status).has_value());
}

TEST(ByteBudget, WaitingDoesNotHelpWhenTheNeedNeverFits) {
  const absl::Status status = ByteReservation::Make(Budget(100), 101).status();
  EXPECT_TRUE(absl::IsResourceExhausted(status));
  EXPECT_THAT(std::string(status.message()), HasSubstr("101"));
  EXPECT_EQ(RetryAfter(status), std::nullopt);
}

// A sum that overflows must not look small.
TEST(ByteBudget, HugeNeedsAreRefused) {
  const auto budget = Budget(100);
  const auto held = ByteReservation::Make(budget, 10);
  EXPECT_FALSE(ByteReservation::Make(budget, ~uint64_t{0} - 5).ok());
  EXPECT_EQ(budget->used(), 10);
}

TEST(ByteReservation, GrowsAndShrinks) {
  const auto budget = Budget(100);
  auto reservation = ByteReservation::Make(budget, 10);
  ASSERT_TRUE(reservation.ok());
  EXPECT_TRUE(reservation->GrowTo(70).ok());
  EXPECT_EQ(budget->used(), 70);
  EXPECT_TRUE(reservation->GrowTo(20).ok());
  EXPECT_EQ(reservation->bytes(), 70);
  EXPECT_TRUE(absl::IsResourceExhausted(reservation->GrowTo(101)));
  EXPECT_EQ(budget->used(), 70);
  reservation->ShrinkTo(80);
  EXPECT_EQ(budget->used(), 70);
  reservation->ShrinkTo(30);
  EXPECT_EQ(budget->used(), 30);
}

TEST(ByteReservation, MovesItsBytes) {
  const auto budget = Budget(100);
  ByteReservation a = *ByteReservation::Make(budget, 30);
  ByteReservation b = *ByteReservation::Make(budget, 50);
  b = std::move(a);
  EXPECT_EQ(budget->used(), 30);
  EXPECT_EQ(b.bytes(), 30);
  const ByteReservation c = std::move(b);
  EXPECT_EQ(budget->used(), 30);
  EXPECT_EQ(c.bytes(), 30);
}

}  // namespace
}  // namespace geodesic::server
