// A request's way through the house: let in, counted, answered, logged.

#ifndef GEODESIC_SERVER_RPC_CALLS_REQUEST_LOG_H_
#define GEODESIC_SERVER_RPC_CALLS_REQUEST_LOG_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/status.h>

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
#include "server/engine/base/clock.h"
#include "server/operations/metrics.h"
#include "server/security/access_control.h"
#include "server/security/caller.h"
#include "server/security/quotas.h"

namespace spdlog {
class logger;
}

namespace geodesic::server {

// Code and message stay (see PrintableMessage). Details follow as google.rpc
// messages: ErrorInfo with the reason always, BadRequest for a field at fault,
// ResourceInfo for a mesh that is not there, QuotaFailure, and RetryInfo when
// waiting helps.
grpc::Status ToGrpcStatus(const absl::Status& status);

// Thread-safe.
class RequestLog {
 public:
  // A request, from its arrival until its last byte is gone. Belongs to the
  // request; not thread-safe.
  class Entry {
   public:
    // REQUIRES: `log` outlives the entry, `context` lives until End.
    Entry(RequestLog& log, std::string_view method,
          grpc::CallbackServerContext& context);
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;
    // Writes the line.
    ~Entry();

    // Whether the caller may ask this; to be asked before anything of the
    // request is looked at.
    // Errors: as AccessControl::Identify, CheckScope, Quotas::TakeRequest.
    absl::Status Admit();

    // Admit, and whether there is room for one more stream. Each holds a
    // message or two, so their number bounds their memory.
    // Errors: as Admit; RESOURCE_EXHAUSTED with a retry hint when the server
    // or the caller has too many requests that have not ended.
    absl::Status AdmitStream();

    // What the request was about, e.g. the start of a digest.
    void set_subject(std::string subject) { subject_ = std::move(subject); }
    void add_bytes(uint64_t bytes) { bytes_ += bytes; }
    // Time in which the client was waited for.
    void add_write_time(Duration time) { write_time_ += time; }

    // Who asks, for the engine (see Requester): the name of the token or, on a
    // server without tokens, the address.
    std::string client() const;

    // The caller's job, once AdmitStream has succeeded. It counts until the
    // request ends and nobody else holds it.
    const std::shared_ptr<Quotas::Job>& job() { return job_; }

    // How the request ends, as gRPC is told; call once, before its Finish.
    grpc::Status End(absl::Status status);

   private:
    RequestLog& log_;
    const std::string_view method_;
    grpc::CallbackServerContext& context_;
    const std::chrono::steady_clock::time_point start_;
    const std::string peer_;
    const std::string request_id_;
    const std::string trace_parent_;
    Caller caller_;
    std::shared_ptr<Quotas::Job> job_;
    std::string subject_;
    absl::Status status_;
    uint64_t bytes_ = 0;
    Duration write_time_{0};
  };

  // What is referred to outlives the log.
  RequestLog(std::shared_ptr<spdlog::logger> logger, size_t max_active,
             const AccessControl& access, Quotas& quotas, Metrics& metrics);

  // Waits until no request is active. False when `until` or a request to stop
  // waiting came first.
  bool WaitIdle(std::chrono::steady_clock::time_point until,
                std::stop_token stop);

  // Requests that have not ended.
  size_t active() const;

 private:
  const std::shared_ptr<spdlog::logger> logger_;
  const size_t max_active_;
  const AccessControl& access_;
  Quotas& quotas_;
  Metrics& metrics_;

  mutable std::mutex mutex_;
  std::condition_variable_any idle_;
  size_t active_ = 0;  // guarded by mutex_
};

// The scope that an RPC needs: `method` without its service, e.g.
// "ComputeField". A method that was forgotten here needs the scope admin.
Scope RequiredScope(std::string_view method);

// A peer's address as gRPC tells it, without the port, which changes from one
// connection to the next: "ipv4:10.1.2.3" of "ipv4:10.1.2.3:53412".
std::string PeerHost(std::string_view peer);

// Enough of a digest to tell meshes apart in a log. What is no digest is not
// quoted: the log is for programs too.
std::string DigestPrefix(std::string_view digest);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_REQUEST_LOG_H_
