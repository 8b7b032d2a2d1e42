// A caller as the server knows it, and what it may do.

#ifndef GEODESIC_SERVER_SECURITY_CALLER_H_
#define GEODESIC_SERVER_SECURITY_CALLER_H_

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace geodesic::server {

// What a caller may do.
enum class Scope : uint8_t {
  kRead,    // ask: look-ups, meshes' arrays, everything that is computed
  kUpload,  // make meshes resident
  kDelete,  // drop meshes
  kAdmin,   // all of these, without quotas
};

struct NamedScope {
  Scope scope;
  std::string_view name;
};
inline constexpr std::array<NamedScope, 4> kScopes = {
    {{Scope::kRead, "read"},
     {Scope::kUpload, "upload"},
     {Scope::kDelete, "delete"},
     {Scope::kAdmin, "admin"}}};

constexpr std::string_view ScopeName(Scope scope) {
  return kScopes[static_cast<size_t>(scope)].name;
}

constexpr std::optional<Scope> ScopeFromName(std::string_view name) {
  for (const NamedScope& known : kScopes) {
    if (known.name == name) return known.scope;
  }
  return std::nullopt;
}

class Scopes {
 public:
  constexpr void Add(Scope scope) { bits_ |= Bit(scope); }
  constexpr bool Allow(Scope scope) const {
    return (bits_ & (Bit(scope) | Bit(Scope::kAdmin))) != 0;
  }

 private:
  static constexpr uint8_t Bit(Scope scope) {
    return static_cast<uint8_t>(1U << static_cast<uint8_t>(scope));
  }

  uint8_t bits_ = 0;
};

// How much of the server one client may use. DEFAULT: no limit.
struct Quota {
  // Memory of the resident meshes that the client uploaded.
  uint64_t resident_bytes = std::numeric_limits<uint64_t>::max();
  // Streams at once: uploads, computations and meshes being read.
  uint64_t jobs = std::numeric_limits<uint64_t>::max();
  // Requests of any kind, on average and in one burst.
  double requests_per_second = std::numeric_limits<double>::infinity();
  double burst = 1;

  friend bool operator==(const Quota&, const Quota&) = default;
};

struct Caller {
  // Tokens of one name share its quota. Empty on a server without tokens.
  std::string name;
  Scopes scopes;
  Quota quota;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SECURITY_CALLER_H_
