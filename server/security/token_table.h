// The tokens a server knows, by their hashes alone.
//
//   {"tokens": [{"name": "ci", "sha256": "9f86d0...", "scopes": ["read"],
//                "expires": "2027-01-31T00:00:00Z"}],
//    "quotas": {"ci": {"resident_bytes": 4000000000, "jobs": 4,
//                      "requests_per_second": 50, "burst": 100},
//               "default": {"jobs": 2}}}
//
// `expires` and `quotas` may be left out, and any number in a quota. "default"
// is for names that have no quota of their own.

#ifndef GEODESIC_SERVER_SECURITY_TOKEN_TABLE_H_
#define GEODESIC_SERVER_SECURITY_TOKEN_TABLE_H_

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "server/security/caller.h"

namespace geodesic::server {

// Immutable, so thread-safe.
class TokenTable {
 public:
  using WallTime = std::chrono::system_clock::time_point;

  // Errors: INVALID_ARGUMENT naming the entry: no JSON of this form; a member
  // it does not know; a hash that is none or comes twice; no scopes; a date
  // that is none.
  static absl::StatusOr<TokenTable> Parse(std::string_view json);

  // The owner of a token. Takes the same time for every token that is not
  // known, however much of a hash it shares. O(tokens).
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

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SECURITY_TOKEN_TABLE_H_
