#include "server/rpc/calls/request_log.h"

#include <spdlog/spdlog.h>

#include <optional>
#include <utility>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "server/engine/base/status_details.h"
#include "server/rpc/calls/request_headers.h"
#include "server/rpc/calls/required_scope.h"
#include "server/rpc/messages/grpc_status.h"

namespace geodesic::server {
namespace {

std::string Named(const char* name, const std::string& value) {
  return value.empty() ? "" : absl::StrCat(" ", name, "=", value);
}

// What one client may have of what others leave: all if that is little.
size_t ShareOf(size_t requests) { return (3 * requests + 3) / 4; }

absl::Status TooManyRequests(const std::string& message) {
  return WithReason(
      WithRetryAfter(absl::ResourceExhaustedError(message), kRetryDelay),
      reason::kTooManyRequests);
}

// Adds the request id to the trailers. When the server is full, also says when
// gRPC's own retries may come, or that they may not.
void AddTrailers(const std::string& request_id, const absl::Status& status,
                 grpc::CallbackServerContext& context) {
  context.AddTrailingMetadata("x-request-id", request_id);
  if (!absl::IsResourceExhausted(status)) return;
  const auto delay = RetryAfter(status);
  context.AddTrailingMetadata(
      "grpc-retry-pushback-ms",
      delay ? absl::StrCat(delay->count()) : std::string("-1"));
}

}  // namespace

RequestLog::RequestLog(std::shared_ptr<spdlog::logger> logger,
                       size_t max_active, const AccessControl& access,
                       const AccessControl& web_access, Quotas& quotas,
                       Metrics& metrics)
    : logger_(std::move(logger)),
      max_active_(max_active),
      access_(access),
      web_access_(web_access),
      quotas_(quotas),
      metrics_(metrics) {}

bool RequestLog::WaitIdle(std::chrono::steady_clock::time_point until,
                          std::stop_token stop) {
  MutexLock lock(mutex_);
  return idle_.wait_until(
      lock, std::move(stop), until,
      [this]() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) { return active_ == 0; });
}

size_t RequestLog::active() const {
  MutexLock lock(mutex_);
  return active_;
}

Duration RequestLog::IdleTime() const {
  MutexLock lock(mutex_);
  if (active_ > 0) return Duration(0);
  return std::chrono::steady_clock::now() - idle_since_;
}

RequestLog::Entry::Entry(RequestLog& log, std::string_view method,
                         grpc::CallbackServerContext& context, Peer peer)
    : log_(log),
      method_(method),
      context_(context),
      start_(std::chrono::steady_clock::now()),
      peer_(std::move(peer)),
      request_id_(RequestId(context)),
      trace_parent_(TraceParent(context)) {
  MutexLock lock(log_.mutex_);
  ++log_.active_;
}

absl::Status RequestLog::Entry::Admit() {
  const size_t count = context_.client_metadata().count("authorization");
  if (count > 1) {
    return WithReason(
        absl::UnauthenticatedError("there are several authorizations"),
        reason::kTokenMissing);
  }
  std::optional<std::string_view> authorization;
  if (count == 1) authorization = Header(context_, "authorization");
  const AccessControl& access = peer_.by_door ? log_.web_access_ : log_.access_;
  absl::StatusOr<Caller> caller = access.Identify(authorization);
  if (!caller.ok()) return caller.status();
  caller_ = *std::move(caller);
  absl::Status status = CheckScope(caller_, RequiredScope(method_));
  if (!status.ok()) return status;
  return log_.quotas_.TakeRequest(caller_);
}

absl::Status RequestLog::Entry::AdmitStream() {
  if (absl::Status status = Admit(); !status.ok()) return status;
  if (absl::Status status = TakeShare(); !status.ok()) return status;
  absl::StatusOr<std::shared_ptr<Quotas::Job>> job =
      log_.quotas_.TakeJob(caller_);
  if (job.ok()) job_ = *std::move(job);
  return job.status();
}

absl::Status RequestLog::Entry::TakeShare() {
  const std::string client = this->client();
  MutexLock lock(log_.mutex_);
  if (log_.active_ > log_.max_active_) {
    return TooManyRequests(absl::StrCat("the server has ", log_.max_active_,
                                        " requests in hand and takes no more; "
                                        "try again later"));
  }
  size_t& streams = log_.streams_[client];
  const size_t left_by_others = log_.max_active_ - (log_.active_ - 1 - streams);
  if (streams + 1 > ShareOf(left_by_others)) {
    return TooManyRequests(absl::StrCat(
        client, " has ", streams,
        " requests in hand, three quarters of what others leave of the "
        "server's limit max-requests; try again when some have ended"));
  }
  ++streams;
  counted_as_ = client;
  return absl::OkStatus();
}

std::string RequestLog::Entry::client() const {
  return caller_.name.empty() ? PeerHost(peer_.address)
                              : absl::StrCat("client:", caller_.name);
}

grpc::Status RequestLog::Entry::End(absl::Status status) {
  AddTrailers(request_id_, status, context_);
  status_ = std::move(status);
  // Freed before the client hears of the end: its next request may need it.
  job_.reset();
  return ToGrpcStatus(status_);
}

RequestLog::Entry::~Entry() {
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - start_;
  log_.metrics_.RequestEnded(
      {.method = method_,
       .status = status_,
       .seconds = seconds.count(),
       .write_seconds = std::chrono::duration<double>(write_time_).count(),
       .bytes = bytes_});
  // INTERNAL is a defect of this program; everything else is ordinary.
  const auto level =
      absl::IsInternal(status_) ? spdlog::level::err : spdlog::level::info;
  log_.logger_->log(
      level,
      "request method={} code={} seconds={:.6f} bytes={}{}{} peer={} id={}{}{}",
      method_, absl::StatusCodeToString(status_.code()), seconds.count(),
      bytes_, Named("mesh", subject_), Named("client", caller_.name),
      peer_.address, request_id_, Named("traceparent", trace_parent_),
      status_.ok() ? ""
                   : absl::StrCat(" reason=", ReasonOf(status_), " error=\"",
                                  absl::CHexEscape(status_.message()), "\""));
  // Notifies under the lock: a waiter may destroy the log as soon as it wakes.
  MutexLock lock(log_.mutex_);
  if (const auto it = log_.streams_.find(counted_as_);
      it != log_.streams_.end() && --it->second == 0) {
    log_.streams_.erase(it);
  }
  if (--log_.active_ == 0) {
    log_.idle_since_ = std::chrono::steady_clock::now();
    log_.idle_.notify_all();
  }
}

std::string DigestPrefix(std::string_view digest) {
  const std::string_view prefix = digest.substr(0, 12);
  return prefix.find_first_not_of("0123456789abcdef") == prefix.npos
             ? std::string(prefix)
             : "malformed";
}

}  // namespace geodesic::server
