// /metrics, /livez and /readyz over HTTP/1.1, for those who watch the server.

#ifndef GEODESIC_SERVER_OPERATIONS_HTTP_SERVER_H_
#define GEODESIC_SERVER_OPERATIONS_HTTP_SERVER_H_

#include <functional>
#include <memory>
#include <string>

#include "absl/status/status.h"

struct MHD_Daemon;

namespace geodesic::server {

// Serves from a thread of its own while it lives, in clear and to everybody who
// reaches it. It only shows numbers, but belongs on an address of the
// operators.
class HttpServer {
 public:
  // Called from that thread; must be short.
  struct Pages {
    std::function<std::string()> metrics;
    std::function<bool()> is_ready;
    // Whether the port that is served accepts connections.
    std::function<bool()> is_alive;
  };

  explicit HttpServer(Pages pages) : pages_(std::move(pages)) {}

  // Listens on "HOST:PORT"; port 0 takes a free one. Call once.
  // Errors: UNAVAILABLE naming the address that could not be bound.
  absl::Status Start(const std::string& address);

  // REQUIRES: Start succeeded.
  int port() const;

 private:
  struct Stop {
    void operator()(MHD_Daemon* daemon) const;
  };

  const Pages pages_;
  // Last, so nobody is served any more when pages_ is destroyed.
  std::unique_ptr<MHD_Daemon, Stop> daemon_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_OPERATIONS_HTTP_SERVER_H_
