#include "server/security/quotas.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "server/engine/base/status_details.h"
#include "server/locks/mutex.h"

namespace geodesic::server {
namespace {

// A rate limit with bursts: holds at most `burst` tokens and gets `rate` of
// them each second. Not thread-safe.
class TokenBucket {
 public:
  // Full. REQUIRES: rate > 0, burst >= 1.
  TokenBucket(double rate, double burst, TimePoint now)
      : rate_(rate), burst_(burst), level_(burst), time_(now) {}

  // Takes a token and returns zero, or returns how long until there is one.
  Duration Take(TimePoint now) {
    // An infinite rate times no time would be NaN.
    if (std::isinf(rate_)) return Duration::zero();
    const std::chrono::duration<double> passed = now - time_;
    level_ = std::min(burst_, level_ + rate_ * passed.count());
    time_ = now;
    if (level_ >= 1) {
      level_ -= 1;
      return Duration::zero();
    }
    return std::chrono::ceil<std::chrono::milliseconds>(
        std::chrono::duration<double>((1 - level_) / rate_));
  }

 private:
  const double rate_;
  const double burst_;
  double level_;
  TimePoint time_;
};

}  // namespace

class Quotas::Account {
 public:
  explicit Account(std::string name) : name_(std::move(name)) {}

  // Called for every request, because a reload may change quotas.
  void SetQuota(const Quota& quota, TimePoint now) {
    MutexLock lock(mutex_);
    if (requests_.has_value() && quota == quota_) return;
    quota_ = quota;
    requests_.emplace(quota.requests_per_second, quota.burst, now);
  }

  absl::Status TakeRequest(TimePoint now) {
    MutexLock lock(mutex_);
    const Duration wait = requests_->Take(now);
    if (wait == Duration::zero()) return absl::OkStatus();
    return WithRetryAfter(
        Exceeded("requests_per_second", quota_.requests_per_second),
        std::chrono::ceil<std::chrono::milliseconds>(wait));
  }

  absl::Status TakeJob() {
    MutexLock lock(mutex_);
    if (jobs_ >= quota_.jobs) {
      return WithRetryAfter(Exceeded("jobs", quota_.jobs), kRetryDelay);
    }
    ++jobs_;
    return absl::OkStatus();
  }

  absl::Status TakeBytes(uint64_t bytes) {
    MutexLock lock(mutex_);
    if (bytes > quota_.resident_bytes) {
      return Exceeded("resident_bytes", quota_.resident_bytes);
    }
    const uint64_t used = ResidentBytes() + uploading_;
    if (used > quota_.resident_bytes - bytes) {
      return WithRetryAfter(Exceeded("resident_bytes", quota_.resident_bytes),
                            kRetryDelay);
    }
    uploading_ += bytes;
    return absl::OkStatus();
  }

  void ReturnJob(uint64_t bytes) {
    MutexLock lock(mutex_);
    --jobs_;
    uploading_ -= bytes;
  }

  void AddMemory(const std::shared_ptr<const void>& memory, uint64_t bytes) {
    MutexLock lock(mutex_);
    held_.push_back({memory, bytes});
  }

 private:
  // Freed memory leaves an expired pointer.
  uint64_t ResidentBytes() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    std::erase_if(held_,
                  [](const Held& held) { return held.memory.expired(); });
    uint64_t bytes = 0;
    for (const Held& held : held_) bytes += held.bytes;
    return bytes;
  }

  template <typename Number>
  absl::Status Exceeded(std::string_view what, Number limit) const {
    return WithQuotaFailure(absl::ResourceExhaustedError(absl::StrCat(
                                "the quota of client ", name_, " is used up: ",
                                std::string(what), " is ", limit)),
                            absl::StrCat("client:", name_));
  }

  struct Held {
    std::weak_ptr<const void> memory;
    uint64_t bytes;
  };

  const std::string name_;
  Mutex mutex_;
  Quota quota_ ABSL_GUARDED_BY(mutex_);
  std::optional<TokenBucket> requests_ ABSL_GUARDED_BY(mutex_);
  uint64_t jobs_ ABSL_GUARDED_BY(mutex_) = 0;
  uint64_t uploading_ ABSL_GUARDED_BY(mutex_) = 0;
  std::vector<Held> held_ ABSL_GUARDED_BY(mutex_);
};

Quotas::Job::~Job() {
  if (account_ != nullptr) account_->ReturnJob(bytes_);
}

absl::Status Quotas::Job::ReserveBytes(uint64_t bytes) {
  if (account_ == nullptr) return absl::OkStatus();
  absl::Status status = account_->TakeBytes(bytes);
  if (status.ok()) bytes_ += bytes;
  return status;
}

void Quotas::Job::AddMemory(const std::shared_ptr<const void>& memory,
                            uint64_t bytes) const {
  if (account_ != nullptr) account_->AddMemory(memory, bytes);
}

absl::Status Quotas::TakeRequest(const Caller& caller) {
  const std::shared_ptr<Account> account = AccountOf(caller);
  return account == nullptr ? absl::OkStatus()
                            : account->TakeRequest(clock_.Now());
}

absl::StatusOr<std::shared_ptr<Quotas::Job>> Quotas::TakeJob(
    const Caller& caller) {
  std::shared_ptr<Account> account = AccountOf(caller);
  absl::Status status =
      account == nullptr ? absl::OkStatus() : account->TakeJob();
  if (!status.ok()) return status;
  return std::make_shared<Job>(std::move(account));
}

std::shared_ptr<Quotas::Account> Quotas::AccountOf(const Caller& caller) {
  if (caller.name.empty() || caller.scopes.Allow(Scope::kAdmin)) return nullptr;
  std::shared_ptr<Account> account;
  {
    MutexLock lock(mutex_);
    std::shared_ptr<Account>& entry = accounts_[caller.name];
    if (entry == nullptr) entry = std::make_shared<Account>(caller.name);
    account = entry;
  }
  account->SetQuota(caller.quota, clock_.Now());
  return account;
}

}  // namespace geodesic::server
