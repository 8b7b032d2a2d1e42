// What a caller may do.

#ifndef GEODESIC_SERVER_SECURITY_SCOPE_H_
#define GEODESIC_SERVER_SECURITY_SCOPE_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace geodesic::server {

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

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SECURITY_SCOPE_H_
