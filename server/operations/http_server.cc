#include "server/operations/http_server.h"

#include <civetweb.h>

#include <array>
#include <string_view>

#include "absl/strings/str_cat.h"

namespace geodesic::server {
namespace {

constexpr int kOk = 200;

int Reply(mg_connection* connection, int code, const std::string& body) {
  const std::string head = absl::StrCat(
      "HTTP/1.1 ", code, " ", mg_get_response_code_text(connection, code),
      "\r\nContent-Type: text/plain; version=0.0.4; charset=utf-8"
      "\r\nCache-Control: no-store\r\nConnection: close\r\nContent-Length: ",
      body.size(), "\r\n\r\n");
  mg_write(connection, head.data(), head.size());
  mg_write(connection, body.data(), body.size());
  return code;
}

int Serve(mg_connection* connection, void* data) {
  const auto& pages = *static_cast<const HttpServer::Pages*>(data);
  const std::string_view path = mg_get_request_info(connection)->local_uri;
  if (path == "/metrics") return Reply(connection, kOk, pages.metrics());
  // Alive is who answers.
  if (path == "/livez") return Reply(connection, kOk, "ok\n");
  if (path == "/readyz") {
    return pages.is_ready() ? Reply(connection, kOk, "ok\n")
                            : Reply(connection, 503, "draining\n");
  }
  return Reply(connection, 404, "there are /metrics, /livez and /readyz\n");
}

}  // namespace

void HttpServer::Stop::operator()(mg_context* context) const {
  mg_stop(context);
}

absl::Status HttpServer::Start(const std::string& address) {
  // Two threads, so that one slow reader does not hide the server's health.
  const std::array<const char*, 9> options = {"listening_ports",
                                              address.c_str(),
                                              "num_threads",
                                              "2",
                                              "request_timeout_ms",
                                              "5000",
                                              "enable_keep_alive",
                                              "no",
                                              nullptr};
  const mg_callbacks callbacks = {};
  context_.reset(
      mg_start(&callbacks, nullptr, const_cast<const char**>(options.data())));
  if (context_ == nullptr) {
    return absl::UnavailableError(absl::StrCat(
        "cannot serve metrics on ", address,
        ": the port is in use or the address is not of this machine"));
  }
  // "/" stands for everything below.
  mg_set_request_handler(context_.get(), "/", &Serve,
                         const_cast<Pages*>(&pages_));
  return absl::OkStatus();
}

int HttpServer::port() const {
  mg_server_port port = {};
  return mg_get_server_ports(context_.get(), 1, &port) == 1 ? port.port : 0;
}

}  // namespace geodesic::server
