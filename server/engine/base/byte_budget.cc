#include "server/engine/base/byte_budget.h"

#include <chrono>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "server/engine/base/status_details.h"

namespace geodesic::server {

ByteBudget::ByteBudget(std::string name, uint64_t capacity)
    : name_(std::move(name)), capacity_(capacity) {}

absl::Status ByteBudget::Take(uint64_t bytes) {
  if (TryTake(bytes)) return absl::OkStatus();
  if (give_back_ && bytes <= capacity_) {
    give_back_();
    if (TryTake(bytes)) return absl::OkStatus();
  }
  return Exhausted(bytes);
}

bool ByteBudget::TryTake(uint64_t bytes) {
  MutexLock lock(mutex_);
  if (bytes > capacity_ - used_) return false;
  used_ += bytes;
  return true;
}

absl::Status ByteBudget::CheckCapacity(uint64_t bytes) const {
  return bytes <= capacity_ ? absl::OkStatus() : Exhausted(bytes);
}

void ByteBudget::Return(uint64_t bytes) {
  MutexLock lock(mutex_);
  used_ -= bytes;
}

absl::Status ByteBudget::Exhausted(uint64_t bytes) const {
  const std::string flag =
      absl::StrCat("--limit ", absl::StrReplaceAll(name_, {{" ", "-"}}));
  if (bytes > capacity_) {
    return absl::ResourceExhaustedError(absl::StrCat(
        bytes, " bytes are needed, more than the ", name_, " of ", capacity_,
        " bytes can ever hold; the server's ", flag, " sets it"));
  }
  const uint64_t in_use = used();
  return WithReason(
      WithRetryAfter(
          absl::ResourceExhaustedError(absl::StrCat(
              bytes, " bytes are needed, but of the ", name_, " of ", capacity_,
              " bytes ", in_use, " are in use and ", capacity_ - in_use,
              " available; try again later, or raise the server's ", flag)),
          kRetryDelay),
      reason::kMemoryFull);
}

uint64_t ByteBudget::used() const {
  MutexLock lock(mutex_);
  return used_;
}

ByteReservation::ByteReservation(std::shared_ptr<ByteBudget> budget,
                                 uint64_t bytes)
    : budget_(std::move(budget)), bytes_(bytes) {}

absl::StatusOr<ByteReservation> ByteReservation::Make(
    std::shared_ptr<ByteBudget> budget, uint64_t bytes) {
  if (absl::Status status = budget->Take(bytes); !status.ok()) return status;
  return ByteReservation(std::move(budget), bytes);
}

ByteReservation::ByteReservation(ByteReservation&& other) noexcept
    : budget_(std::move(other.budget_)),
      bytes_(std::exchange(other.bytes_, 0)) {}

ByteReservation& ByteReservation::operator=(ByteReservation&& other) noexcept {
  if (this != &other) {
    ShrinkTo(0);
    budget_ = std::move(other.budget_);
    bytes_ = std::exchange(other.bytes_, 0);
  }
  return *this;
}

ByteReservation::~ByteReservation() { ShrinkTo(0); }

absl::Status ByteReservation::GrowTo(uint64_t bytes) {
  if (bytes <= bytes_) return absl::OkStatus();
  absl::Status status = budget_->CheckCapacity(bytes);
  if (status.ok()) status = budget_->Take(bytes - bytes_);
  if (!status.ok()) return status;
  bytes_ = bytes;
  return absl::OkStatus();
}

void ByteReservation::ShrinkTo(uint64_t bytes) {
  if (bytes >= bytes_) return;
  budget_->Return(bytes_ - bytes);
  bytes_ = bytes;
}

}  // namespace geodesic::server
