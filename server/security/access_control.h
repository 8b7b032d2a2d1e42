// Lets a request in, or says why not.

#ifndef GEODESIC_SERVER_SECURITY_ACCESS_CONTROL_H_
#define GEODESIC_SERVER_SECURITY_ACCESS_CONTROL_H_

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/security/caller.h"
#include "server/security/token_table.h"

namespace geodesic::server {

// Thread-safe.
class AccessControl {
 public:
  using WallClock = std::function<TokenTable::WallTime()>;

  // `token_file` as token_table.h has it; without one everybody may do
  // everything. Nobody is let in before the first Reload.
  explicit AccessControl(std::string token_file,
                         WallClock now = &std::chrono::system_clock::now);

  // Takes up the file as it is now. When that fails what was there before
  // stays in force.
  // Errors: NOT_FOUND, PERMISSION_DENIED: it cannot be read; as
  // TokenTable::Parse.
  absl::Status Reload();

  // Who calls, by the value of the "authorization" header, if there is one.
  // Errors: UNAUTHENTICATED, reason TOKEN_MISSING when there is none or it is
  // no bearer token; as TokenTable::Find.
  absl::StatusOr<Caller> Identify(
      std::optional<std::string_view> authorization) const;

  const std::string& token_file() const { return token_file_; }

 private:
  const std::string token_file_;
  const WallClock now_;

  mutable std::mutex mutex_;
  std::shared_ptr<const TokenTable> table_;  // guarded by mutex_
};

// Errors: PERMISSION_DENIED, reason SCOPE_MISSING, naming the scope.
absl::Status CheckScope(const Caller& caller, Scope scope);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SECURITY_ACCESS_CONTROL_H_
