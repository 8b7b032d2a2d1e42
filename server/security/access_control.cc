#include "server/security/access_control.h"

#include <openssl/crypto.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "digest/sha256.h"
#include "server/engine/base/status_details.h"
#include "server/security/file_text.h"

namespace geodesic::server {
namespace {

constexpr std::string_view kBearer = "bearer ";

// The token in "Bearer TOKEN"; the scheme is not case-sensitive (RFC 9110).
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

using Json = nlohmann::json;
using WallTime = TokenTable::WallTime;

constexpr char kDefaultQuota[] = "default";
constexpr size_t kMaxNameBytes = 64;

absl::Status Wrong(std::string_view where, std::string_view what) {
  return absl::InvalidArgumentError(
      absl::StrCat(std::string(where), " ", std::string(what)));
}

// Whether `json` is an object with no other members than these: a typing error
// must not grant rights.
absl::Status CheckObject(const Json& json, const std::string& where,
                         std::initializer_list<std::string_view> known) {
  if (!json.is_object()) return Wrong(where, "is no object");
  for (const auto& [name, value] : json.items()) {
    bool is_known = false;
    for (const std::string_view member : known) is_known |= name == member;
    if (!is_known) {
      return Wrong(
          where, absl::StrCat("has a member \"", name, "\" that is not known"));
    }
  }
  return absl::OkStatus();
}

// The string member `name`.
absl::StatusOr<std::string> Text(const Json& json, const std::string& where,
                                 const char* name) {
  const auto it = json.find(name);
  if (it == json.end() || !it->is_string()) {
    return Wrong(where, absl::StrCat("has no text \"", name, "\""));
  }
  return it->get<std::string>();
}

// "2027-01-31T00:00:00Z"
absl::StatusOr<WallTime> ParseTime(const std::string& text,
                                   const std::string& where) {
  std::tm time = {};
  const char* end = strptime(text.c_str(), "%Y-%m-%dT%H:%M:%SZ", &time);
  if (end == nullptr || *end != '\0') {
    return Wrong(where,
                 "has an \"expires\" that is not as 2027-01-31T00:00:00Z");
  }
  return std::chrono::system_clock::from_time_t(timegm(&time));
}

absl::StatusOr<Scopes> ParseScopes(const Json& json, const std::string& where) {
  const auto it = json.find("scopes");
  if (it == json.end() || !it->is_array() || it->empty()) {
    return Wrong(where, "has no \"scopes\"");
  }
  Scopes scopes;
  for (const Json& name : *it) {
    const auto scope = name.is_string() ? ScopeFromName(name.get<std::string>())
                                        : std::nullopt;
    if (!scope) {
      return Wrong(where,
                   "has a scope that is none of read, upload, delete, admin");
    }
    scopes.Add(*scope);
  }
  return scopes;
}

// Sets `value` from the member `name`, if there is one.
template <typename Number>
absl::Status SetNumber(const Json& json, const std::string& where,
                       const char* name, Number& value) {
  const auto it = json.find(name);
  if (it == json.end()) return absl::OkStatus();
  constexpr bool kWhole = std::is_integral_v<Number>;
  if (kWhole ? !it->is_number_unsigned()
             : !it->is_number() || !(it->get<double>() > 0)) {
    return Wrong(where, absl::StrCat("has a \"", name, "\" that is no ",
                                     kWhole ? "whole number" : "number > 0"));
  }
  value = it->get<Number>();
  return absl::OkStatus();
}

absl::StatusOr<Quota> ParseQuota(const Json& json, const std::string& where) {
  absl::Status status = CheckObject(
      json, where, {"resident_bytes", "jobs", "requests_per_second", "burst"});
  if (!status.ok()) return status;
  Quota quota;
  status = SetNumber(json, where, "resident_bytes", quota.resident_bytes);
  status.Update(SetNumber(json, where, "jobs", quota.jobs));
  status.Update(
      SetNumber(json, where, "requests_per_second", quota.requests_per_second));
  if (!status.ok()) return status;
  // The default burst is the requests of one second.
  if (std::isfinite(quota.requests_per_second)) {
    quota.burst = std::max(1.0, quota.requests_per_second);
  }
  status = SetNumber(json, where, "burst", quota.burst);
  if (status.ok() && quota.burst < 1) {
    return Wrong(where, "has a \"burst\" below 1: nothing could be asked");
  }
  if (!status.ok()) return status;
  return quota;
}

absl::StatusOr<std::map<std::string, Quota>> ParseQuotas(const Json& json) {
  std::map<std::string, Quota> quotas;
  const auto it = json.find("quotas");
  if (it == json.end()) return quotas;
  if (!it->is_object()) return Wrong("quotas", "is no object");
  for (const auto& [name, value] : it->items()) {
    absl::StatusOr<Quota> quota =
        ParseQuota(value, absl::StrCat("quotas.", name));
    if (!quota.ok()) return quota.status();
    quotas.emplace(name, *quota);
  }
  return quotas;
}

absl::Status CheckName(const std::string& name, const std::string& where) {
  bool fine =
      !name.empty() && name.size() <= kMaxNameBytes && name != kDefaultQuota;
  for (const char c : name) fine &= c > ' ' && c <= '~' && c != '"';
  if (fine) return absl::OkStatus();
  return Wrong(where,
               "has a \"name\" that is not 1 to 64 printable characters other "
               "than \"default\"");
}

absl::Status Refused(std::string_view reason, std::string_view message) {
  return WithReason(absl::UnauthenticatedError(std::string(message)), reason);
}

}  // namespace

absl::StatusOr<TokenTable> TokenTable::Parse(std::string_view text) {
  const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded()) return Wrong("the file", "is no JSON");
  absl::Status status = CheckObject(json, "the file", {"tokens", "quotas"});
  if (!status.ok()) return status;
  const auto tokens = json.find("tokens");
  if (tokens == json.end() || !tokens->is_array()) {
    return Wrong("the file", "has no list \"tokens\"");
  }
  absl::StatusOr<std::map<std::string, Quota>> quotas = ParseQuotas(json);
  if (!quotas.ok()) return quotas.status();

  TokenTable table;
  for (const Json& token : *tokens) {
    const std::string where =
        absl::StrCat("tokens[", table.entries_.size(), "]");
    status = CheckObject(token, where, {"name", "sha256", "scopes", "expires"});
    if (!status.ok()) return status;
    absl::StatusOr<std::string> name = Text(token, where, "name");
    if (!name.ok()) return name.status();
    if (status = CheckName(*name, where); !status.ok()) return status;
    absl::StatusOr<std::string> hash = Text(token, where, "sha256");
    if (!hash.ok()) return hash.status();
    // The value is not quoted, because it may be the token itself.
    if (!IsSha256Hex(*hash)) {
      return Wrong(where,
                   "has a \"sha256\" that is not 64 lower-case hexadecimal "
                   "digits");
    }
    absl::StatusOr<Scopes> scopes = ParseScopes(token, where);
    if (!scopes.ok()) return scopes.status();
    Entry entry{.sha256 = *std::move(hash), .expires = WallTime::max()};
    for (const Entry& other : table.entries_) {
      if (other.sha256 == entry.sha256) {
        return Wrong(where, "has the hash of another token");
      }
    }
    if (token.contains("expires")) {
      absl::StatusOr<std::string> expires = Text(token, where, "expires");
      if (!expires.ok()) return expires.status();
      absl::StatusOr<WallTime> time = ParseTime(*expires, where);
      if (!time.ok()) return time.status();
      entry.expires = *time;
    }
    auto quota = quotas->find(*name);
    if (quota == quotas->end()) quota = quotas->find(kDefaultQuota);
    entry.caller = {.name = *std::move(name), .scopes = *scopes};
    if (quota != quotas->end()) entry.caller.quota = quota->second;
    table.entries_.push_back(std::move(entry));
  }
  return table;
}

absl::StatusOr<Caller> TokenTable::Find(std::string_view token,
                                        WallTime now) const {
  const std::string hash = Sha256Hex(token);
  const Entry* found = nullptr;
  for (const Entry& entry : entries_) {
    if (CRYPTO_memcmp(entry.sha256.data(), hash.data(), hash.size()) == 0) {
      found = &entry;
    }
  }
  if (found == nullptr) {
    return Refused(reason::kTokenUnknown, "the token is not known");
  }
  if (found->expires <= now) {
    return Refused(reason::kTokenExpired, "the token has expired");
  }
  return found->caller;
}

AccessControl::AccessControl(std::string token_file, WallClock now)
    : token_file_(std::move(token_file)),
      now_(std::move(now)),
      table_(std::make_shared<TokenTable>()) {}

absl::Status AccessControl::Reload() {
  if (token_file_.empty()) return absl::OkStatus();
  const absl::StatusOr<std::string> text = ReadFileText(token_file_);
  if (!text.ok()) return text.status();
  absl::StatusOr<TokenTable> table = TokenTable::Parse(*text);
  if (!table.ok()) {
    return absl::InvalidArgumentError(
        absl::StrCat(token_file_, ": ", std::string(table.status().message())));
  }
  auto fresh = std::make_shared<const TokenTable>(*std::move(table));
  MutexLock lock(mutex_);
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
    MutexLock lock(mutex_);
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
