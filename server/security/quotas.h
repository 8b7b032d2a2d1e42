// Counts what each client uses of the server, against its quota.

#ifndef GEODESIC_SERVER_SECURITY_QUOTAS_H_
#define GEODESIC_SERVER_SECURITY_QUOTAS_H_

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/engine/base/clock.h"
#include "server/locks/mutex.h"
#include "server/security/caller.h"

namespace geodesic::server {

// Counts by the callers' names. Callers with the scope admin, and those without
// a name, are not counted. All errors are RESOURCE_EXHAUSTED, reason
// QUOTA_EXCEEDED, and name the client and its quota. Thread-safe.
class Quotas {
 public:
  class Account;

  // A running job and the bytes its upload will take. Gives both back when it
  // is destroyed. Not thread-safe.
  class Job {
   public:
    // `account` is charged; null: the job is not counted.
    explicit Job(std::shared_ptr<Account> account)
        : account_(std::move(account)) {}
    ~Job();
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

    // Reserves the bytes that an upload will make resident.
    // Errors: without a retry hint if they exceed the whole quota.
    absl::Status ReserveBytes(uint64_t bytes);

    // Counts `bytes` for what the upload made resident until nobody holds
    // `memory` any more; the job may end before. Thread-safe.
    void AddMemory(const std::shared_ptr<const void>& memory,
                   uint64_t bytes) const;

   private:
    const std::shared_ptr<Account> account_;
    uint64_t bytes_ = 0;
  };

  // REQUIRES: `clock` outlives the quotas.
  explicit Quotas(const Clock& clock) : clock_(clock) {}

  // Counts a request. Errors: with a hint when to come again.
  absl::Status TakeRequest(const Caller& caller);

  // Errors: with a retry hint.
  absl::StatusOr<std::shared_ptr<Job>> TakeJob(const Caller& caller);

 private:
  // Null for a caller that is not counted.
  std::shared_ptr<Account> AccountOf(const Caller& caller);

  const Clock& clock_;

  Mutex mutex_;
  // By name.
  std::map<std::string, std::shared_ptr<Account>> accounts_
      ABSL_GUARDED_BY(mutex_);
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SECURITY_QUOTAS_H_
