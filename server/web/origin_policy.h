// Which pages may call the server.
//
// A browser lets any page send requests to any server. Two checks keep pages of
// others from using the server of whoever looks at them. A request must name
// this server by an address, "localhost" or a name that it was given: a page
// whose name was pointed at this machine (DNS rebinding) has another. And its
// page must come from here, or from an origin that was allowed.

#ifndef GEODESIC_SERVER_WEB_ORIGIN_POLICY_H_
#define GEODESIC_SERVER_WEB_ORIGIN_POLICY_H_

#include <string>
#include <string_view>
#include <vector>

namespace geodesic::server {

// Immutable, so thread-safe.
class OriginPolicy {
 public:
  // `listen` is HOST:PORT, over TLS if so. `origins` are as browsers write
  // them, e.g. "https://geo.example.org".
  OriginPolicy(std::string_view listen, bool over_tls,
               std::vector<std::string> origins);

  // Whether this server answers for the "host" of a request. That of an allowed
  // origin is one, too: a proxy may pass it on.
  bool IsHost(std::string_view host) const;

  // Whether the page of this "origin" was loaded from "host".
  bool IsOwn(std::string_view origin, std::string_view host) const;

  // Whether pages of this other origin may call.
  bool IsAllowed(std::string_view origin) const;

 private:
  const std::string name_;
  const std::string scheme_;
  const std::vector<std::string> origins_;
};

// Whether `text` is an origin: http:// or https:// and HOST or HOST:PORT.
bool IsOrigin(std::string_view text);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_WEB_ORIGIN_POLICY_H_
