#include "server/rpc/calls/request_log.h"

#include <google/rpc/error_details.pb.h>
#include <google/rpc/status.pb.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <optional>
#include <random>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "geodesic/field_path.h"
#include "server/engine/base/status_details.h"

namespace geodesic::server {
namespace {

// Streams end within seconds unless their readers stall.
constexpr std::chrono::milliseconds kRetryDelay{1000};

std::string Named(const char* name, const std::string& value) {
  return value.empty() ? "" : absl::StrCat(" ", name, "=", value);
}

constexpr std::pair<std::string_view, Scope> kRequired[] = {
    {"FindMissingMeshes", Scope::kRead}, {"GetMesh", Scope::kRead},
    {"ReadMesh", Scope::kRead},          {"DecimateMesh", Scope::kRead},
    {"ListMeshes", Scope::kRead},        {"CreateMesh", Scope::kUpload},
    {"DeleteMesh", Scope::kDelete},      {"ComputeField", Scope::kRead},
    {"ComputeLogMap", Scope::kRead},     {"SampleFarthestPoints", Scope::kRead},
    {"ComputePaths", Scope::kRead},      {"ComputeIsolines", Scope::kRead},
    {"ComputeMatrix", Scope::kRead},     {"ComputePairs", Scope::kRead},
    {"FindNearest", Scope::kRead},       {"PrepareMethod", Scope::kRead},
    {"GetCapabilities", Scope::kRead},
};

constexpr size_t kMaxRequestIdBytes = 64;

// The first value of the header; empty if there is none.
std::string_view Header(const grpc::CallbackServerContext& context,
                        const char* name) {
  const auto& metadata = context.client_metadata();
  const auto it = metadata.find(name);
  if (it == metadata.end()) return {};
  return {it->second.data(), it->second.size()};
}

bool IsLoggable(char c) {
  return absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '-' ||
         c == '_' || c == '.';
}

// The client's "x-request-id" if it can be logged: up to 64 letters, digits and
// "-_."; else one of the server's.
std::string RequestId(const grpc::CallbackServerContext& context) {
  const std::string_view given = Header(context, "x-request-id");
  if (!given.empty() && given.size() <= kMaxRequestIdBytes &&
      std::ranges::all_of(given, IsLoggable)) {
    return std::string(given);
  }
  // Unique enough to find a line in a log.
  thread_local std::mt19937_64 random{std::random_device{}()};
  const uint64_t number = random();
  return absl::StrCat(absl::Hex(number, absl::kZeroPad16));
}

// The "traceparent" of W3C's Trace Context if it has that form, else nothing.
std::string TraceParent(const grpc::CallbackServerContext& context) {
  // version "-" trace id "-" parent id "-" flags
  constexpr size_t kBytes = 2 + 1 + 32 + 1 + 16 + 1 + 2;
  const std::string_view given = Header(context, "traceparent");
  const auto is_dash = [](size_t i) { return i == 2 || i == 35 || i == 52; };
  if (given.size() != kBytes) return "";
  for (size_t i = 0; i < kBytes; ++i) {
    const auto c = static_cast<unsigned char>(given[i]);
    if (is_dash(i) ? c != '-' : !absl::ascii_isxdigit(c)) return "";
  }
  return std::string(given);
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

grpc::Status ToGrpcStatus(const absl::Status& status) {
  if (status.ok()) return grpc::Status::OK;
  // absl and gRPC number the codes alike.
  const auto code = static_cast<grpc::StatusCode>(status.code());
  const std::string message = PrintableMessage(status);

  google::rpc::Status details;
  google::rpc::ErrorInfo info;
  info.set_reason(ReasonOf(status));
  info.set_domain("geodesic.v1");
  details.add_details()->PackFrom(info);
  if (const auto field = FieldPathOf(status)) {
    google::rpc::BadRequest bad_request;
    auto& violation = *bad_request.add_field_violations();
    violation.set_field(*field);
    violation.set_description(message);
    details.add_details()->PackFrom(bad_request);
  }
  if (const auto digest = MeshAtFault(status)) {
    google::rpc::ResourceInfo resource;
    resource.set_resource_type("geodesic.v1.Mesh");
    resource.set_resource_name(*digest);
    resource.set_description(message);
    details.add_details()->PackFrom(resource);
  }
  if (const auto subject = QuotaSubject(status)) {
    google::rpc::QuotaFailure quota;
    quota.add_violations()->set_subject(*subject);
    quota.mutable_violations(0)->set_description(message);
    details.add_details()->PackFrom(quota);
  }
  if (const auto delay = RetryAfter(status)) {
    google::rpc::RetryInfo retry;
    retry.mutable_retry_delay()->set_seconds(delay->count() / 1000);
    retry.mutable_retry_delay()->set_nanos(
        static_cast<int32_t>(delay->count() % 1000 * 1'000'000));
    details.add_details()->PackFrom(retry);
  }
  details.set_code(code);
  details.set_message(message);
  return grpc::Status(code, message, details.SerializeAsString());
}

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
  std::unique_lock lock(mutex_);
  return idle_.wait_until(lock, std::move(stop), until,
                          [this] { return active_ == 0; });
}

size_t RequestLog::active() const {
  std::lock_guard lock(mutex_);
  return active_;
}

Duration RequestLog::IdleTime() const {
  std::lock_guard lock(mutex_);
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
  std::lock_guard lock(log_.mutex_);
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
  if (log_.active() > log_.max_active_) {
    return WithReason(
        WithRetryAfter(absl::ResourceExhaustedError(absl::StrCat(
                           "the server has ", log_.max_active_,
                           " requests in hand and takes no more; try again "
                           "later")),
                       kRetryDelay),
        reason::kTooManyRequests);
  }
  absl::StatusOr<std::shared_ptr<Quotas::Job>> job =
      log_.quotas_.TakeJob(caller_);
  if (job.ok()) job_ = *std::move(job);
  return job.status();
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
  std::lock_guard lock(log_.mutex_);
  if (--log_.active_ == 0) {
    log_.idle_since_ = std::chrono::steady_clock::now();
    log_.idle_.notify_all();
  }
}

Scope RequiredScope(std::string_view method) {
  for (const auto& [name, scope] : kRequired) {
    if (name == method) return scope;
  }
  return Scope::kAdmin;
}

std::string PeerHost(std::string_view peer) {
  // The colons of an IPv6 address are escaped or in brackets.
  const bool has_port = peer.starts_with("ipv4:") || peer.starts_with("ipv6:");
  return std::string(has_port ? peer.substr(0, peer.rfind(':')) : peer);
}

std::string DigestPrefix(std::string_view digest) {
  const std::string_view prefix = digest.substr(0, 12);
  return prefix.find_first_not_of("0123456789abcdef") == prefix.npos
             ? std::string(prefix)
             : "malformed";
}

}  // namespace geodesic::server
