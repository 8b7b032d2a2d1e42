#include "server/security/access_control.h"

#include <gtest/gtest.h>

#include <string>

#include "digest/sha256.h"
#include "server/engine/base/status_details.h"
#include "tests/support/temporary_folder.h"

namespace geodesic::server {
namespace {

std::string TokenFor(const std::string& name, const std::string& token) {
  return R"({"tokens": [{"name": ")" + name + R"(", "sha256": ")" +
         Sha256Hex(token) + R"(", "scopes": ["read"]}]})";
}

class AccessControlTest : public ::testing::Test {
 protected:
  void Write(const std::string& text) {
    geodesic::test::WriteFile(folder_ / "tokens.json", text);
  }

  void ExpectRefused(std::optional<std::string_view> authorization,
                     std::string_view why) {
    const absl::Status status = control_.Identify(authorization).status();
    EXPECT_TRUE(absl::IsUnauthenticated(status));
    EXPECT_EQ(ReasonOf(status), why);
  }

  const geodesic::test::TemporaryFolder folder_;
  AccessControl control_{folder_ / "tokens.json"};
};

TEST_F(AccessControlTest, NobodyIsLetInBeforeTheFileIsRead) {
  Write(TokenFor("ci", "t1"));
  ExpectRefused("Bearer t1", reason::kTokenUnknown);
  ASSERT_TRUE(control_.Reload().ok());
  EXPECT_EQ(control_.Identify("Bearer t1")->name, "ci");
  EXPECT_EQ(control_.Identify("bEARER t1")->name, "ci");
}

TEST_F(AccessControlTest, OtherHeadersAreNone) {
  Write(TokenFor("ci", "t1"));
  ASSERT_TRUE(control_.Reload().ok());
  ExpectRefused(std::nullopt, reason::kTokenMissing);
  ExpectRefused("", reason::kTokenMissing);
  ExpectRefused("Bearer", reason::kTokenMissing);
  ExpectRefused("Bearer ", reason::kTokenMissing);
  ExpectRefused("Basic dDE=", reason::kTokenMissing);
  ExpectRefused("t1", reason::kTokenMissing);
  ExpectRefused("Bearer  t1", reason::kTokenUnknown);
}

TEST_F(AccessControlTest, AReloadEndsOldTokensUnlessItFails) {
  Write(TokenFor("ci", "t1"));
  ASSERT_TRUE(control_.Reload().ok());
  Write("{");
  EXPECT_TRUE(absl::IsInvalidArgument(control_.Reload()));
  EXPECT_TRUE(control_.Identify("Bearer t1").ok());
  Write(TokenFor("ci", "t2"));
  ASSERT_TRUE(control_.Reload().ok());
  ExpectRefused("Bearer t1", reason::kTokenUnknown);
  EXPECT_TRUE(control_.Identify("Bearer t2").ok());
}

TEST_F(AccessControlTest, AMissingFileIsNamed) {
  const absl::Status status = control_.Reload();
  EXPECT_TRUE(absl::IsNotFound(status));
  EXPECT_NE(status.message().find("tokens.json"), std::string::npos);
}

TEST(AccessControl, WithoutAFileEverybodyMayDoEverything) {
  AccessControl control("");
  ASSERT_TRUE(control.Reload().ok());
  const auto caller = control.Identify(std::nullopt);
  ASSERT_TRUE(caller.ok());
  EXPECT_TRUE(CheckScope(*caller, Scope::kDelete).ok());
}

TEST(AccessControl, AScopeAllowsItselfAndAdminAll) {
  Caller reader, admin;
  reader.scopes.Add(Scope::kRead);
  admin.scopes.Add(Scope::kAdmin);
  EXPECT_TRUE(CheckScope(reader, Scope::kRead).ok());
  for (const NamedScope& scope : kScopes) {
    EXPECT_TRUE(CheckScope(admin, scope.scope).ok());
    if (scope.scope == Scope::kRead) continue;
    const absl::Status status = CheckScope(reader, scope.scope);
    EXPECT_TRUE(absl::IsPermissionDenied(status));
    EXPECT_EQ(ReasonOf(status), reason::kScopeMissing);
  }
}

}  // namespace
}  // namespace geodesic::server
