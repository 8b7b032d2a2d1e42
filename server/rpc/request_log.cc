#include "server/rpc/request_log.h"

#include <spdlog/spdlog.h>

#include <utility>

#include "absl/strings/str_cat.h"
#include "server/engine/status_details.h"

namespace geodesic::server {

namespace {

// Streams end within seconds unless their readers stall.
constexpr std::chrono::milliseconds kRetryDelay{1000};

}  // namespace

RequestLog::RequestLog(std::shared_ptr<spdlog::logger> logger,
                       size_t max_active)
    : logger_(std::move(logger)), max_active_(max_active) {}

absl::Status RequestLog::CheckRoom() const {
  if (active() <= max_active_) return absl::OkStatus();
  return WithRetryAfter(
      absl::ResourceExhaustedError(
          absl::StrCat("the server has ", max_active_,
                       " requests in hand and takes no more; try again later")),
      kRetryDelay);
}

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

RequestLog::Entry::Entry(RequestLog& log, std::string_view method)
    : log_(log), method_(method), start_(std::chrono::steady_clock::now()) {
  std::lock_guard lock(log_.mutex_);
  ++log_.active_;
}

RequestLog::Entry::~Entry() {
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - start_;
  // INTERNAL is a defect of this program; everything else is ordinary.
  const auto level =
      absl::IsInternal(status_) ? spdlog::level::err : spdlog::level::info;
  log_.logger_->log(level, "{} {} {:.6f}s {} bytes{}{}{}{}", method_,
                    absl::StatusCodeToString(status_.code()), seconds.count(),
                    bytes_, subject_.empty() ? "" : " ", subject_,
                    status_.ok() ? "" : ": ", PrintableMessage(status_));
  // Under the lock, so that a waiter who then lets the log go finds nobody
  // in it.
  std::lock_guard lock(log_.mutex_);
  if (--log_.active_ == 0) log_.idle_.notify_all();
}

std::string DigestPrefix(std::string_view digest) {
  return std::string(digest.substr(0, 12));
}

}  // namespace geodesic::server
