#include "server/security/access_control.h"

#include <cerrno>
#include <fstream>
#include <sstream>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "server/engine/base/error_reasons.h"
#include "server/engine/base/status_details.h"

namespace geodesic::server {
namespace {

constexpr std::string_view kBearer = "bearer ";

// The token in "Bearer TOKEN"; the scheme is in any case (RFC 9110).
std::optional<std::string_view> BearerToken(std::string_view authorization) {
  if (authorization.size() <= kBearer.size()) return std::nullopt;
  for (size_t i = 0; i < kBearer.size(); ++i) {
    if (absl::ascii_tolower(static_cast<unsigned char>(authorization[i])) !=
        kBearer[i]) {
      return std::nullopt;
    }
  }
  return authorization.substr(kBearer.size());
}

}  // namespace

AccessControl::AccessControl(std::string token_file, WallClock now)
    : token_file_(std::move(token_file)),
      now_(std::move(now)),
      table_(std::make_shared<TokenTable>()) {}

absl::Status AccessControl::Reload() {
  if (token_file_.empty()) return absl::OkStatus();
  std::ifstream file(token_file_);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) {
    return absl::ErrnoToStatus(errno,
                               absl::StrCat("cannot read ", token_file_));
  }
  absl::StatusOr<TokenTable> table = TokenTable::Parse(text.str());
  if (!table.ok()) {
    return absl::InvalidArgumentError(
        absl::StrCat(token_file_, ": ", std::string(table.status().message())));
  }
  auto fresh = std::make_shared<const TokenTable>(*std::move(table));
  std::lock_guard lock(mutex_);
  table_.swap(fresh);
  return absl::OkStatus();
}

absl::StatusOr<Caller> AccessControl::Identify(
    std::optional<std::string_view> authorization) const {
  if (token_file_.empty()) {
    Caller everybody;
    everybody.scopes.Add(Scope::kAdmin);
    return everybody;
  }
  const auto token = authorization ? BearerToken(*authorization) : std::nullopt;
  if (!token) {
    return WithReason(
        absl::UnauthenticatedError(
            "this server wants a token: metadata \"authorization\" of the form "
            "\"Bearer TOKEN\""),
        reason::kTokenMissing);
  }
  std::shared_ptr<const TokenTable> table;
  {
    std::lock_guard lock(mutex_);
    table = table_;
  }
  return table->Find(*token, now_());
}

absl::Status CheckScope(const Caller& caller, Scope scope) {
  if (caller.scopes.Allow(scope)) return absl::OkStatus();
  return WithReason(absl::PermissionDeniedError(
                        absl::StrCat("the token does not have the scope \"",
                                     std::string(ScopeName(scope)), "\"")),
                    reason::kScopeMissing);
}

}  // namespace geodesic::server
