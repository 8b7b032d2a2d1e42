// Admits requests by a file of the tokens' hashes:
//
//   {"tokens": [{"name": "ci", "sha256": "9f86d0...", "scopes": ["read"],
//                "expires": "2027-01-31T00:00:00Z"}],
//    "quotas": {"ci": {"resident_bytes": 4000000000, "jobs": 4,
//                      "requests_per_second": 50, "burst": 100},
//               "default": {"jobs": 2}}}
//
// `expires` and `quotas` may be left out, and any number in a quota. "default"
// is for names without a quota of their own.

#ifndef GEODESIC_SERVER_SECURITY_ACCESS_CONTROL_H_
#define GEODESIC_SERVER_SECURITY_ACCESS_CONTROL_H_

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/locks/mutex.h"
#include "server/security/caller.h"

namespace geodesic::server {

// The tokens a server knows, by their hashes alone. Immutable, so thread-safe.
class TokenTable {
 public:
  using WallTime = std::chrono::system_clock::time_point;

  // Errors: INVALID_ARGUMENT naming the entry: no JSON of this form; an unknown
  // member; a malformed or repeated hash; no scopes; a malformed date.
  static absl::StatusOr<TokenTable> Parse(std::string_view json);

  // The owner of a token. Takes the same time for every unknown token, however
  // much of a known hash its own hash shares. O(tokens).
  // Errors: UNAUTHENTICATED, with reason TOKEN_UNKNOWN or TOKEN_EXPIRED.
  absl::StatusOr<Caller> Find(std::string_view token, WallTime now) const;

  size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    std::string sha256;  // 64 digits
    WallTime expires;
    Caller caller;
  };

  std::vector<Entry> entries_;
};

// Thread-safe.
class AccessControl {
 public:
  using WallClock = std::function<TokenTable::WallTime()>;

  // `token_file` of the form above; without one everybody may do
  // everything. Nobody is let in before the first Reload.
  explicit AccessControl(std::string token_file,
                         WallClock now = &std::chrono::system_clock::now);

  // Reads the file. If that fails, the tokens read before stay in force.
  // Errors: NOT_FOUND, PERMISSION_DENIED: the file cannot be read; as
  // TokenTable::Parse.
  absl::Status Reload();

  // The caller, by the value of the "authorization" header, if there is one.
  // Errors: UNAUTHENTICATED, reason TOKEN_MISSING when there is none or it is
  // no bearer token; as TokenTable::Find.
  absl::StatusOr<Caller> Identify(
      std::optional<std::string_view> authorization) const;

 private:
  const std::string token_file_;
  const WallClock now_;

  mutable Mutex mutex_;
  std::shared_ptr<const TokenTable> table_ ABSL_GUARDED_BY(mutex_);
};

// Errors: PERMISSION_DENIED, reason SCOPE_MISSING, naming the scope.
absl::Status CheckScope(const Caller& caller, Scope scope);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SECURITY_ACCESS_CONTROL_H_
