// Memory is reserved from a budget before it is allocated, and goes back to it
// after it is freed.
//
//   auto budget = std::make_shared<ByteBudget>("upload memory", 1 << 30);
//   absl::StatusOr<ByteReservation> room =
//       ByteReservation::Make(budget, chunk.size());

#ifndef GEODESIC_SERVER_ENGINE_BASE_BYTE_BUDGET_H_
#define GEODESIC_SERVER_ENGINE_BASE_BYTE_BUDGET_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/locks/mutex.h"

namespace geodesic::server {

// A number of bytes shared by many holders. Thread-safe; used() never exceeds
// capacity().
class ByteBudget {
 public:
  // `name` appears in messages; it is the server's flag in words, e.g. "mesh
  // store" for the limit mesh-store.
  ByteBudget(std::string name, uint64_t capacity);

  // Takes `bytes`, all or nothing.
  // Errors: RESOURCE_EXHAUSTED naming the budget, its flag, and the bytes
  // needed, used and free; with a retry hint unless the budget is too small.
  absl::Status Take(uint64_t bytes);

  // Whether so many bytes can ever be taken. Errors: as Take.
  absl::Status CheckCapacity(uint64_t bytes) const;

  // REQUIRES: taken before.
  void Return(uint64_t bytes);

  // From now on Take calls `give_back` before it fails, and then tries again.
  // It returns bytes that are held for convenience alone. Call before any other
  // method.
  void OnShortage(std::function<void()> give_back) {
    give_back_ = std::move(give_back);
  }

  uint64_t used() const;
  uint64_t capacity() const { return capacity_; }

 private:
  bool TryTake(uint64_t bytes);
  // The error of Take.
  absl::Status Exhausted(uint64_t bytes) const;

  const std::string name_;
  const uint64_t capacity_;
  std::function<void()> give_back_;  // may be empty

  mutable Mutex mutex_;
  uint64_t used_ ABSL_GUARDED_BY(mutex_) = 0;
};

// Bytes taken from a budget, returned on destruction. Movable; not thread-safe.
class ByteReservation {
 public:
  // Holds nothing and belongs to no budget.
  ByteReservation() = default;

  // Errors: as ByteBudget::Take.
  static absl::StatusOr<ByteReservation> Make(
      std::shared_ptr<ByteBudget> budget, uint64_t bytes);

  ByteReservation(ByteReservation&& other) noexcept;
  ByteReservation& operator=(ByteReservation&& other) noexcept;
  ~ByteReservation();

  // Errors: as ByteBudget::Take, without a retry hint when the budget can never
  // hold that many; the reservation then stays as it is.
  absl::Status GrowTo(uint64_t bytes);

  // Does nothing unless `bytes` is less than bytes().
  void ShrinkTo(uint64_t bytes);

  uint64_t bytes() const { return bytes_; }

 private:
  ByteReservation(std::shared_ptr<ByteBudget> budget, uint64_t bytes);

  std::shared_ptr<ByteBudget> budget_;
  uint64_t bytes_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_BASE_BYTE_BUDGET_H_
