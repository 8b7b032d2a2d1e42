#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/engine/base/status_details.h"
#include "server/security/access_control.h"

namespace geodesic::server {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using WallTime = TokenTable::WallTime;

// printf %s sesame | sha256sum
constexpr char kSesame[] =
    "d0c04f4b1951e4aeaaec8223ed2039e542f3aae805a6fa7f6d794e5afff5d272";
// 2026-01-01T00:00:00Z, as date -u -d ... +%s tells it
const WallTime kNewYear = std::chrono::system_clock::from_time_t(1767225600);

std::string OneToken(const std::string& members) {
  return R"({"tokens": [{"name": "ci", "sha256": ")" + std::string(kSesame) +
         R"(", "scopes": ["read", "upload"])" + members + "}]";
}

TEST(TokenTable, AKnownTokenHasItsOwnersScopes) {
  const auto table = TokenTable::Parse(OneToken("") + "}");
  ASSERT_TRUE(table.ok()) << table.status();
  const auto caller = table->Find("sesame", kNewYear);
  ASSERT_TRUE(caller.ok()) << caller.status();
  EXPECT_EQ(caller->name, "ci");
  EXPECT_TRUE(caller->scopes.Allow(Scope::kRead));
  EXPECT_TRUE(caller->scopes.Allow(Scope::kUpload));
  EXPECT_FALSE(caller->scopes.Allow(Scope::kDelete));
  EXPECT_FALSE(caller->scopes.Allow(Scope::kAdmin));
  EXPECT_EQ(caller->quota, Quota());
}

TEST(TokenTable, OthersAreNotKnown) {
  const auto table = TokenTable::Parse(OneToken("") + "}");
  ASSERT_TRUE(table.ok());
  // The hash itself is no token.
  for (const std::string token : {"", "Sesame", "sesame ", kSesame}) {
    const absl::Status status = table->Find(token, kNewYear).status();
    EXPECT_TRUE(absl::IsUnauthenticated(status));
    EXPECT_EQ(ReasonOf(status), reason::kTokenUnknown);
    EXPECT_THAT(status.ToString(), Not(HasSubstr("esame")));
  }
}

TEST(TokenTable, ATokenEndsAtItsTime) {
  const auto table = TokenTable::Parse(
      OneToken(R"(, "expires": "2026-01-01T00:00:00Z")") + "}");
  ASSERT_TRUE(table.ok()) << table.status();
  EXPECT_TRUE(table->Find("sesame", kNewYear - std::chrono::seconds(1)).ok());
  const absl::Status status = table->Find("sesame", kNewYear).status();
  EXPECT_TRUE(absl::IsUnauthenticated(status));
  EXPECT_EQ(ReasonOf(status), reason::kTokenExpired);
}

TEST(TokenTable, QuotasGoByName) {
  const auto own =
      TokenTable::Parse(OneToken("") + R"(, "quotas": {"default": {"jobs": 2},
      "ci": {"resident_bytes": 5, "requests_per_second": 0.5}}})");
  ASSERT_TRUE(own.ok()) << own.status();
  const Quota quota = own->Find("sesame", kNewYear)->quota;
  EXPECT_EQ(quota.resident_bytes, 5);
  EXPECT_EQ(quota.jobs, Quota().jobs);
  EXPECT_EQ(quota.requests_per_second, 0.5);
  EXPECT_EQ(quota.burst, 1);
  const auto usual = TokenTable::Parse(
      OneToken("") + R"(, "quotas": {"default": {"jobs": 2}}})");
  ASSERT_TRUE(usual.ok()) << usual.status();
  EXPECT_EQ(usual->Find("sesame", kNewYear)->quota.jobs, 2);
}

TEST(TokenTable, WhatIsWrongIsNamedAndNeverQuoted) {
  const auto expect = [](const std::string& text, const std::string& words) {
    const absl::Status status = TokenTable::Parse(text).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << text;
    EXPECT_THAT(std::string(status.message()), HasSubstr(words));
    EXPECT_THAT(std::string(status.message()), Not(HasSubstr("secret")));
  };
  const std::string hash = "\"sha256\": \"" + std::string(kSesame) + "\"";
  const auto with = [](const std::string& members) {
    return "{\"tokens\": [{" + members + "}]}";
  };
  expect("", "JSON");
  expect("{}", "\"tokens\"");
  expect("[]", "object");
  expect(R"({"tokens": [], "qotas": {}})", "qotas");
  expect(with(R"("name": "a", "sha256": "secret", "scopes": ["read"])"),
         "tokens[0] has a \"sha256\"");
  expect(with("\"name\": \"a\", \"scopes\": [\"read\"]"), "sha256");
  expect(with("\"name\": \"a\", " + hash), "scopes");
  expect(with("\"name\": \"a\", \"scopes\": [], " + hash), "scopes");
  expect(with("\"name\": \"a\", \"scopes\": [\"all\"], " + hash), "admin");
  expect(with("\"name\": \"a b\", \"scopes\": [\"read\"], " + hash), "name");
  expect(with("\"name\": \"default\", \"scopes\": [\"read\"], " + hash),
         "name");
  expect(with("\"name\": \"a\", \"scope\": [\"read\"], " + hash), "\"scope\"");
  expect(OneToken(", \"expires\": \"2026-01-01\"") + "}", "expires");
  expect(OneToken(", \"expires\": 7") + "}", "expires");
  expect(OneToken("") + ", \"quotas\": {\"ci\": {\"jobs\": -1}}}",
         "quotas.ci has a \"jobs\"");
  expect(OneToken("") + ", \"quotas\": {\"ci\": {\"burst\": 0.5}}}", "burst");
  expect(OneToken("") + ", \"quotas\": {\"ci\": {\"job\": 1}}}", "\"job\"");
  const std::string one = OneToken("");
  const std::string entry = one.substr(12, one.size() - 13);
  expect("{\"tokens\": [" + entry + ", " + entry + "]}", "tokens[1]");
}

}  // namespace
}  // namespace geodesic::server
