// Admits, counts and logs requests.

#ifndef GEODESIC_SERVER_RPC_CALLS_REQUEST_LOG_H_
#define GEODESIC_SERVER_RPC_CALLS_REQUEST_LOG_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/status.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "server/engine/base/clock.h"
#include "server/locks/mutex.h"
#include "server/operations/metrics.h"
#include "server/rpc/calls/peer.h"
#include "server/security/access_control.h"
#include "server/security/caller.h"
#include "server/security/quotas.h"

namespace spdlog {
class logger;
}

namespace geodesic::server {

// Thread-safe.
class RequestLog {
 public:
  // One request, from its arrival until its last byte is sent. Not thread-safe.
  class Entry {
   public:
    // REQUIRES: `log` outlives the entry, `context` lives until End.
    Entry(RequestLog& log, std::string_view method,
          grpc::CallbackServerContext& context, Peer peer);
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;
    // Writes the line of the log.
    ~Entry();

    // Whether the caller may make this request. Call before looking at anything
    // in it.
    // Errors: as AccessControl::Identify, CheckScope, Quotas::TakeRequest.
    absl::Status Admit();

    // Admit, and whether there is room for one more stream. A stream holds a
    // message or two, so the number of streams bounds their memory.
    // Errors: as Admit; RESOURCE_EXHAUSTED with a retry hint when the server
    // or the caller has too many requests that have not ended. Of what other
    // callers leave, one may have three quarters, so that no one can take all.
    absl::Status AdmitStream();

    // What the request is about, e.g. the start of a digest.
    void set_subject(std::string subject) { subject_ = std::move(subject); }
    void add_bytes(uint64_t bytes) { bytes_ += bytes; }
    // Adds time spent waiting for the client.
    void add_write_time(Duration time) { write_time_ += time; }

    // The client's name for the engine (see Requester): the token's name or, on
    // a server without tokens, the address.
    std::string client() const;

    // The caller's job, once AdmitStream has succeeded. It counts until the
    // request ends and nobody else holds it.
    const std::shared_ptr<Quotas::Job>& job() { return job_; }

    // Ends the request; returns the status for gRPC. Call once, before Finish.
    grpc::Status End(absl::Status status);
    // What the log says in place of the status of End, which the client did not
    // take.
    void set_status(absl::Status status) { status_ = std::move(status); }

   private:
    // Counts this stream as its client's. Errors: as AdmitStream.
    absl::Status TakeShare();

    RequestLog& log_;
    const std::string_view method_;
    grpc::CallbackServerContext& context_;
    const std::chrono::steady_clock::time_point start_;
    const Peer peer_;
    const std::string request_id_;
    const std::string trace_parent_;
    Caller caller_;
    std::shared_ptr<Quotas::Job> job_;
    std::string counted_as_;  // a client's name; empty: not counted
    std::string subject_;
    absl::Status status_;
    uint64_t bytes_ = 0;
    Duration write_time_{0};
  };

  // `web_access` is asked for callers who come by the door for browsers.
  // REQUIRES: the references outlive the log.
  RequestLog(std::shared_ptr<spdlog::logger> logger, size_t max_active,
             const AccessControl& access, const AccessControl& web_access,
             Quotas& quotas, Metrics& metrics);

  // Waits until no request is active. False if `until` or `stop` came first.
  bool WaitIdle(std::chrono::steady_clock::time_point until,
                std::stop_token stop);

  // Requests that have not ended.
  size_t active() const;

  // How long no request has been active; zero while one is.
  Duration IdleTime() const;

 private:
  const std::shared_ptr<spdlog::logger> logger_;
  const size_t max_active_;
  const AccessControl& access_;
  const AccessControl& web_access_;
  Quotas& quotas_;
  Metrics& metrics_;

  mutable Mutex mutex_;
  std::condition_variable_any idle_;
  size_t active_ ABSL_GUARDED_BY(mutex_) = 0;
  // By clients' names.
  std::map<std::string, size_t> streams_ ABSL_GUARDED_BY(mutex_);
  std::chrono::steady_clock::time_point idle_since_ ABSL_GUARDED_BY(mutex_) =
      std::chrono::steady_clock::now();
};

// Enough of a digest to tell meshes apart in a log. Other text is not quoted,
// because programs read the log, too.
std::string DigestPrefix(std::string_view digest);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_REQUEST_LOG_H_
