// What each client has taken of the server, against its quota.

#ifndef GEODESIC_SERVER_SECURITY_QUOTAS_H_
#define GEODESIC_SERVER_SECURITY_QUOTAS_H_

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/engine/base/clock.h"
#include "server/security/caller.h"

namespace geodesic::server {

// Counts by the callers' names. Callers with the scope admin, and those without
// a name, are not counted. All errors are RESOURCE_EXHAUSTED, reason
// QUOTA_EXCEEDED, and name the client and its quota. Thread-safe.
class Quotas {
 public:
  class Account;
  class Job;

  // Who pays for what stays in memory.
  class MemoryCharge {
   public:
    MemoryCharge() = default;

    // The bytes count until nobody holds `memory` any more. Thread-safe.
    void Add(const std::shared_ptr<const void>& memory, uint64_t bytes) const;

   private:
    friend class Job;
    explicit MemoryCharge(std::shared_ptr<Account> account)
        : account_(std::move(account)) {}

    std::shared_ptr<Account> account_;  // null: nobody
  };

  // A job under way and the bytes its upload will take. Gives them back at the
  // end. Not thread-safe; outlives nothing it needs.
  class Job {
   public:
    Job() = default;
    Job(Job&& other) noexcept;
    Job& operator=(Job&& other) noexcept;
    ~Job();

    // Before an upload: that so many bytes more may become resident.
    // Errors: with no retry hint when they never could.
    absl::Status ReserveBytes(uint64_t bytes);

    // For the mesh that the upload makes resident; may outlive the job.
    MemoryCharge memory_charge() const { return MemoryCharge(account_); }

   private:
    friend class Quotas;
    explicit Job(std::shared_ptr<Account> account);
    void Return();

    std::shared_ptr<Account> account_;  // null: not counted
    uint64_t bytes_ = 0;
  };

  // REQUIRES: `clock` outlives the quotas.
  explicit Quotas(const Clock& clock) : clock_(clock) {}

  // Counts a request. Errors: with a hint when the next may come.
  absl::Status TakeRequest(const Caller& caller);

  // Errors: with a retry hint.
  absl::StatusOr<Job> TakeJob(const Caller& caller);

 private:
  // Null for those who are not counted.
  std::shared_ptr<Account> AccountOf(const Caller& caller);

  const Clock& clock_;

  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Account>> accounts_;  // by name
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SECURITY_QUOTAS_H_
