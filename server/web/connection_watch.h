// What the HTTP server does not see of its connections: that a browser goes
// while its connection is suspended, and that one sends a request byte by byte
// for ever.

#ifndef GEODESIC_SERVER_WEB_CONNECTION_WATCH_H_
#define GEODESIC_SERVER_WEB_CONNECTION_WATCH_H_

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <stop_token>
#include <thread>

#include "server/locks/mutex.h"
#include "server/web/web_call.h"

namespace geodesic::server {

// Watches from a thread of its own while it lives. Thread-safe.
class ConnectionWatch {
 public:
  // Shuts connections that are late by more than `patience`.
  explicit ConnectionWatch(std::chrono::seconds patience);
  ~ConnectionWatch();
  ConnectionWatch(const ConnectionWatch&) = delete;
  ConnectionWatch& operator=(const ConnectionWatch&) = delete;

  // A connection has come, of which a request is expected. Returns its number.
  uint64_t Open(int socket);

  // REQUIRES: its socket is open still.
  void Close(uint64_t connection);

  // What comes next, a request's head or a message of its body, must be there
  // within the patience; or the server has the connection wait.
  void Expect(uint64_t connection);
  void Rest(uint64_t connection);

  // This call leaves when the browser does.
  void Attach(uint64_t connection, const std::shared_ptr<WebCall>& call);
  void Detach(uint64_t connection);

  // All calls leave, and those that begin afterwards. Waits for nothing.
  void LeaveAll();

 private:
  using Clock = std::chrono::steady_clock;
  struct Connection {
    int socket;
    Clock::time_point until;  // max(): for as long as it likes
    bool is_gone = false;
    std::weak_ptr<WebCall> call;
  };

  void Run(const std::stop_token& stop);
  void ShutLate();
  void Gone(uint64_t connection);

  const std::chrono::seconds patience_;
  const int epoll_;
  const int wake_;  // ends Run

  Mutex mutex_;
  uint64_t next_ ABSL_GUARDED_BY(mutex_) = 1;
  bool is_closing_ ABSL_GUARDED_BY(mutex_) = false;
  std::map<uint64_t, Connection> connections_ ABSL_GUARDED_BY(mutex_);

  std::jthread thread_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_WEB_CONNECTION_WATCH_H_
