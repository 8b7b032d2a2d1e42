#include "client/src/retry.h"

#include <gtest/gtest.h>

#include <stop_token>

namespace geodesic::client {
namespace {

TEST(RetryTest, OnlyWhatMayPassIsTriedAgain) {
  const std::stop_token never;
  EXPECT_FALSE(WaitToRetry(absl::InvalidArgumentError("no"), 1, never));
  // A limit: no word of when to come again.
  EXPECT_FALSE(WaitToRetry(absl::ResourceExhaustedError("no"), 1, never));
  EXPECT_TRUE(WaitToRetry(absl::UnavailableError("later"), 1, never));
}

TEST(RetryTest, NotForEver) {
  EXPECT_FALSE(
      WaitToRetry(absl::UnavailableError("later"), 4, std::stop_token()));
}

TEST(RetryTest, ARequestToStopEndsTheWait) {
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(
      WaitToRetry(absl::UnavailableError("later"), 1, source.get_token()));
}

}  // namespace
}  // namespace geodesic::client
