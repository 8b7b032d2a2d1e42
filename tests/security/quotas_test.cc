#include "server/security/quotas.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include "server/engine/base/status_details.h"
#include "tests/engine/fakes.h"

namespace geodesic::server {
namespace {

using std::chrono::milliseconds;

Caller Named(const std::string& name, const Quota& quota,
             Scope scope = Scope::kRead) {
  Caller caller{.name = name, .quota = quota};
  caller.scopes.Add(scope);
  return caller;
}

void ExpectExceeded(const absl::Status& status, bool waiting_helps) {
  EXPECT_TRUE(absl::IsResourceExhausted(status));
  EXPECT_EQ(ReasonOf(status), reason::kQuotaExceeded);
  EXPECT_EQ(QuotaSubject(status), "client:ci");
  EXPECT_EQ(RetryAfter(status).has_value(), waiting_helps);
}

class QuotasTest : public ::testing::Test {
 protected:
  test::FakeClock clock_;
  Quotas quotas_{clock_};
};

TEST_F(QuotasTest, ABurstPassesThenTheRateHolds) {
  const Caller ci = Named("ci", {.requests_per_second = 10, .burst = 3});
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(quotas_.TakeRequest(ci).ok());
  const absl::Status refused = quotas_.TakeRequest(ci);
  ExpectExceeded(refused, true);
  EXPECT_EQ(RetryAfter(refused), milliseconds(100));
  clock_.Advance(milliseconds(99));
  EXPECT_FALSE(quotas_.TakeRequest(ci).ok());
  clock_.Advance(milliseconds(1));
  EXPECT_TRUE(quotas_.TakeRequest(ci).ok());
  EXPECT_FALSE(quotas_.TakeRequest(ci).ok());
  // A long rest is worth no more than a burst.
  clock_.Advance(std::chrono::hours(1));
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(quotas_.TakeRequest(ci).ok());
  EXPECT_FALSE(quotas_.TakeRequest(ci).ok());
}

TEST_F(QuotasTest, EachNameHasItsOwn) {
  const Quota quota{.requests_per_second = 1, .burst = 1};
  EXPECT_TRUE(quotas_.TakeRequest(Named("ci", quota)).ok());
  EXPECT_FALSE(quotas_.TakeRequest(Named("ci", quota)).ok());
  EXPECT_TRUE(quotas_.TakeRequest(Named("other", quota)).ok());
  // Admins and the nameless are not counted.
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(quotas_.TakeRequest(Named("", quota)).ok());
    EXPECT_TRUE(quotas_.TakeRequest(Named("root", quota, Scope::kAdmin)).ok());
  }
}

TEST_F(QuotasTest, AnotherQuotaTakesEffectAtOnce) {
  EXPECT_TRUE(
      quotas_.TakeRequest(Named("ci", {.requests_per_second = 1, .burst = 1}))
          .ok());
  EXPECT_TRUE(
      quotas_.TakeRequest(Named("ci", {.requests_per_second = 1, .burst = 2}))
          .ok());
}

TEST_F(QuotasTest, JobsAreGivenBackAtTheirEnd) {
  const Caller ci = Named("ci", {.jobs = 2});
  const auto first = quotas_.TakeJob(ci);
  {
    const auto second = quotas_.TakeJob(ci);
    ASSERT_TRUE(first.ok() && second.ok());
    ExpectExceeded(quotas_.TakeJob(ci).status(), true);
  }
  EXPECT_TRUE(quotas_.TakeJob(ci).ok());
}

TEST_F(QuotasTest, MemoryCountsUntilItIsGone) {
  auto resident = std::make_shared<const int>();
  const uint64_t bytes = 1000;
  const Caller ci = Named("ci", {.resident_bytes = 2 * bytes - 1});
  {
    auto upload = quotas_.TakeJob(ci);
    ASSERT_TRUE(upload.ok());
    EXPECT_TRUE((*upload)->ReserveBytes(bytes).ok());
    // An upload under way counts before its mesh is there.
    auto other = quotas_.TakeJob(ci);
    ExpectExceeded((*other)->ReserveBytes(bytes), true);
    ExpectExceeded((*other)->ReserveBytes(2 * bytes), false);
    (*upload)->AddMemory(resident, bytes);
  }
  ExpectExceeded((*quotas_.TakeJob(ci))->ReserveBytes(bytes), true);
  EXPECT_TRUE((*quotas_.TakeJob(ci))->ReserveBytes(bytes - 1).ok());
  resident.reset();
  EXPECT_TRUE((*quotas_.TakeJob(ci))->ReserveBytes(2 * bytes - 1).ok());
}

TEST_F(QuotasTest, AnUploadGivesAllBackThatItTookPieceByPiece) {
  const Caller ci = Named("ci", {.resident_bytes = 1000});
  for (int round = 0; round < 2; ++round) {
    const auto upload = quotas_.TakeJob(ci);
    ASSERT_TRUE(upload.ok());
    EXPECT_TRUE((*upload)->ReserveBytes(600).ok()) << round;
    EXPECT_TRUE((*upload)->ReserveBytes(400).ok()) << round;
    ExpectExceeded((*upload)->ReserveBytes(1), true);
  }
}

}  // namespace
}  // namespace geodesic::server
