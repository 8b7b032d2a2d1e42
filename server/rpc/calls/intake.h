// How requests come in: how long they may take, and what they may hold.

#ifndef GEODESIC_SERVER_RPC_CALLS_INTAKE_H_
#define GEODESIC_SERVER_RPC_CALLS_INTAKE_H_

#include <google/protobuf/message.h>
#include <grpcpp/alarm.h>
#include <grpcpp/support/byte_buffer.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/engine/base/byte_budget.h"
#include "server/rpc/calls/receive_slots.h"

namespace geodesic::server {

// Thread-safe.
class Intake {
 public:
  struct Options {
    // Messages that may be received at once.
    uint64_t slots = 64;
    // What has not come as a whole after so long is waited for no longer.
    std::chrono::milliseconds patience{60'000};
    // For what is decoded.
    uint64_t memory_bytes = uint64_t{1} << 30;
  };

  explicit Intake(const Options& options);

  // Decodes a request, and reserves memory for it and for the question that is
  // made from it before it does.
  // Errors: INVALID_ARGUMENT: malformed; RESOURCE_EXHAUSTED naming the request
  // memory, with a retry hint when an idle server would have it.
  absl::StatusOr<ByteReservation> Decode(
      grpc::ByteBuffer& bytes, google::protobuf::Message& request) const;

  // Lets go of what was reserved for the request, which is gone, and keeps what
  // the question takes. Call once.
  static void ReleaseRequest(ByteReservation& reservation);

  ReceiveSlots& slots() { return slots_; }
  std::chrono::milliseconds patience() const { return patience_; }
  const ByteBudget& memory() const { return *memory_; }

 private:
  const std::shared_ptr<ByteBudget> memory_;
  const std::chrono::milliseconds patience_;
  ReceiveSlots slots_;
};

// Watches one message come in. Not thread-safe.
class Arrival {
 public:
  // Calls `late`, from a thread of gRPC's, if Stop does not come in time. It
  // may still be called while Stop is.
  void Start(std::chrono::milliseconds patience, std::function<void()> late);
  void Stop() { alarm_.reset(); }

 private:
  std::optional<grpc::Alarm> alarm_;
};

// The error of a message that was late.
absl::Status LateError(std::chrono::milliseconds patience);

// The error of one that was broken off, so that others can be received.
absl::Status BrokenOffError();

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_INTAKE_H_
