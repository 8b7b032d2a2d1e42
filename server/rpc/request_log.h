// One log line per request, and the number of requests in the house, which has
// a limit.

#ifndef GEODESIC_SERVER_RPC_REQUEST_LOG_H_
#define GEODESIC_SERVER_RPC_REQUEST_LOG_H_

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"

namespace spdlog {
class logger;
}

namespace geodesic::server {

// Thread-safe.
class RequestLog {
 public:
  // A request, from its arrival until its last byte is gone. Belongs to the
  // request; not thread-safe.
  class Entry {
   public:
    // REQUIRES: `log` outlives the entry.
    Entry(RequestLog& log, std::string_view method);
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;
    // Writes the line.
    ~Entry();

    // What the request was about, e.g. the start of a digest.
    void set_subject(std::string subject) { subject_ = std::move(subject); }
    void set_status(absl::Status status) { status_ = std::move(status); }
    void add_bytes(uint64_t bytes) { bytes_ += bytes; }

   private:
    RequestLog& log_;
    const std::string_view method_;
    const std::chrono::steady_clock::time_point start_;
    std::string subject_;
    absl::Status status_;
    uint64_t bytes_ = 0;
  };

  RequestLog(std::shared_ptr<spdlog::logger> logger, size_t max_active);

  // Whether a request whose entry has been made may go on to stream. Each
  // stream holds a message or two, so their number bounds their memory.
  // Errors: RESOURCE_EXHAUSTED with a retry hint when more than `max_active`
  // requests have not ended.
  absl::Status CheckRoom() const;

  // Waits until no request is active. False when `until` or a request to stop
  // waiting came first.
  bool WaitIdle(std::chrono::steady_clock::time_point until,
                std::stop_token stop);

  // Requests that have not ended.
  size_t active() const;

 private:
  const std::shared_ptr<spdlog::logger> logger_;
  const size_t max_active_;

  mutable std::mutex mutex_;
  std::condition_variable_any idle_;
  size_t active_ = 0;  // guarded by mutex_
};

// Enough of a digest to tell meshes apart in a log.
std::string DigestPrefix(std::string_view digest);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_REQUEST_LOG_H_
