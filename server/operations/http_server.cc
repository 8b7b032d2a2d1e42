#include "server/operations/http_server.h"

#include <microhttpd.h>

#include <string_view>

#include "absl/strings/str_cat.h"
#include "server/operations/listen_address.h"

namespace geodesic::server {
namespace {

// Enough for all who watch a server, and for many idle connections.
constexpr unsigned kMostConnections = 512;
// Beyond these an address's connections are closed at once, so that whoever
// opens many and is silent keeps no other address waiting.
constexpr unsigned kMostOfAnAddress = 64;
constexpr unsigned kIdleSeconds = 10;
// A request's head must fit in here.
constexpr size_t kConnectionBytes = 8192;

MHD_Result Reply(MHD_Connection* connection, unsigned code, std::string body) {
  MHD_Response* response = MHD_create_response_from_buffer(
      body.size(), body.data(), MHD_RESPMEM_MUST_COPY);
  if (response == nullptr) return MHD_NO;
  MHD_add_response_header(response, MHD_HTTP_HEADER_CONTENT_TYPE,
                          "text/plain; version=0.0.4; charset=utf-8");
  MHD_add_response_header(response, MHD_HTTP_HEADER_CACHE_CONTROL, "no-store");
  MHD_add_response_header(response, MHD_HTTP_HEADER_CONNECTION, "close");
  const MHD_Result result = MHD_queue_response(connection, code, response);
  MHD_destroy_response(response);
  return result;
}

MHD_Result Serve(void* data, MHD_Connection* connection, const char* url,
                 const char* method, const char*, const char*, size_t*,
                 void**) {
  const auto& pages = *static_cast<const HttpServer::Pages*>(data);
  const std::string_view path = url, verb = method;
  if (verb != MHD_HTTP_METHOD_GET && verb != MHD_HTTP_METHOD_HEAD) {
    return Reply(connection, MHD_HTTP_METHOD_NOT_ALLOWED, "GET only\n");
  }
  if (path == "/metrics") {
    return Reply(connection, MHD_HTTP_OK, pages.metrics());
  }
  if (path == "/livez") {
    return pages.is_alive() ? Reply(connection, MHD_HTTP_OK, "ok\n")
                            : Reply(connection, MHD_HTTP_SERVICE_UNAVAILABLE,
                                    "the server accepts no connections\n");
  }
  if (path == "/readyz") {
    return pages.is_ready()
               ? Reply(connection, MHD_HTTP_OK, "ok\n")
               : Reply(connection, MHD_HTTP_SERVICE_UNAVAILABLE, "draining\n");
  }
  return Reply(connection, MHD_HTTP_NOT_FOUND,
               "there are /metrics, /livez and /readyz\n");
}

}  // namespace

void HttpServer::Stop::operator()(MHD_Daemon* daemon) const {
  MHD_stop_daemon(daemon);
}

absl::Status HttpServer::Start(const std::string& address) {
  const auto resolved = ResolveListenAddress(address);
  if (resolved == nullptr) {
    return absl::UnavailableError(
        absl::StrCat("cannot serve metrics on ", address,
                     ": it is no HOST:PORT of this machine"));
  }
  // One thread serves all connections by epoll, so a client that sends half a
  // request or reads slowly holds nobody up.
  unsigned flags = MHD_USE_EPOLL_INTERNAL_THREAD | MHD_USE_ITC;
  if (resolved->ai_family == AF_INET6) flags |= MHD_USE_IPv6;
  daemon_.reset(MHD_start_daemon(
      flags, 0, nullptr, nullptr, &Serve, const_cast<Pages*>(&pages_),
      MHD_OPTION_SOCK_ADDR, resolved->ai_addr, MHD_OPTION_CONNECTION_LIMIT,
      kMostConnections, MHD_OPTION_PER_IP_CONNECTION_LIMIT, kMostOfAnAddress,
      MHD_OPTION_CONNECTION_TIMEOUT, kIdleSeconds,
      MHD_OPTION_CONNECTION_MEMORY_LIMIT, kConnectionBytes, MHD_OPTION_END));
  if (daemon_ != nullptr) return absl::OkStatus();
  return absl::UnavailableError(absl::StrCat(
      "cannot serve metrics on ", address,
      ": the port is in use or the address is not of this machine"));
}

int HttpServer::port() const {
  return MHD_get_daemon_info(daemon_.get(), MHD_DAEMON_INFO_BIND_PORT)->port;
}

}  // namespace geodesic::server
