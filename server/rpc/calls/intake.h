// Bounds how many messages are received at once, how long each may take, and
// how much memory requests hold.
//
// gRPC may allocate memory for the largest message while it receives one, so
// each reception takes a slot. A call without a slot waits; flow control then
// stops its client after 64 KiB. A client that sends slowly, or not at all,
// must not keep others out, so connections share the slots evenly: if one waits
// that has fewer slots than another, the other's oldest reception is broken
// off, unless it is young.

#ifndef GEODESIC_SERVER_RPC_CALLS_INTAKE_H_
#define GEODESIC_SERVER_RPC_CALLS_INTAKE_H_

#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/zero_copy_stream.h>
#include <google/protobuf/message.h>
#include <grpcpp/alarm.h>
#include <grpcpp/support/byte_buffer.h>

#include <chrono>
#include <cstdint>
#include <deque>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/engine/base/byte_budget.h"
#include "server/locks/mutex.h"

namespace geodesic::server {

// Receives a message. Both methods are called without a lock of the intake.
class Receiver {
 public:
  virtual ~Receiver() = default;

  // A slot is free: read, then call Leave.
  virtual void OnSlot() = 0;

  // Others wait: end the call. Called again and again until Leave.
  virtual void OnBrokenOff() = 0;
};

// Thread-safe.
class Intake {
 public:
  struct Options {
    // Messages that may be received at once.
    uint64_t slots = 64;
    // How long a message may take to come in.
    std::chrono::milliseconds patience{60'000};
    // The budget of decoded requests.
    uint64_t memory_bytes = uint64_t{1} << 30;
  };

  explicit Intake(const Options& options);

  // Gives `receiver` a slot, at once or later. `connection` tells connections
  // apart. REQUIRES: the caller holds no lock that OnSlot takes.
  void Enter(std::shared_ptr<Receiver> receiver, const std::string& connection);

  // REQUIRES: `receiver` has a slot; the caller holds no lock that another
  // receiver's OnSlot takes.
  void Leave(const Receiver& receiver);

  // Reserves memory for a request and for the question that is made from it,
  // then decodes the request.
  // Errors: INVALID_ARGUMENT: malformed; RESOURCE_EXHAUSTED naming the request
  // memory, with a retry hint unless that is too small.
  absl::StatusOr<ByteReservation> Decode(
      grpc::ByteBuffer& bytes, google::protobuf::Message& request) const;

  // Returns the memory of the request, which is gone, and keeps that of the
  // question. Call once.
  static void ReleaseRequest(ByteReservation& reservation);

  std::chrono::milliseconds patience() const { return patience_; }
  const ByteBudget& memory() const { return *memory_; }

 private:
  using Clock = std::chrono::steady_clock;

  struct Reception {
    std::shared_ptr<Receiver> receiver;
    std::string connection;
    Clock::time_point since;
  };
  struct Connection {
    size_t held = 0;
    std::deque<std::shared_ptr<Receiver>> waiting;
  };

  // Gives free slots to receivers that wait.
  void Serve() ABSL_LOCKS_EXCLUDED(mutex_);
  // Breaks receptions off for receivers that wait; runs again while some wait.
  void MakeRoom() ABSL_LOCKS_EXCLUDED(mutex_);
  // The waiting connection that has the fewest slots; null if none waits.
  std::pair<const std::string, Connection>* Neediest()
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  void Watch() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);

  const std::shared_ptr<ByteBudget> memory_;
  const std::chrono::milliseconds patience_;

  Mutex mutex_;
  uint64_t free_slots_ ABSL_GUARDED_BY(mutex_);
  std::map<std::string, Connection> connections_ ABSL_GUARDED_BY(mutex_);
  std::list<Reception> held_ ABSL_GUARDED_BY(mutex_);  // oldest first
  std::optional<grpc::Alarm> alarm_ ABSL_GUARDED_BY(mutex_);
  bool is_watching_ ABSL_GUARDED_BY(mutex_) = false;
};

// An upper bound on the memory that a message of this type takes when it is
// parsed from these bytes; two bytes can become 70. Allocates nothing for the
// content. If the bytes are malformed, counts the part before the fault, for
// which a parser may have allocated memory. O(bytes).
uint64_t DecodedSize(const google::protobuf::Descriptor& type,
                     google::protobuf::io::ZeroCopyInputStream& bytes);

// The error of a call whose message was late.
absl::Status LateError(std::chrono::milliseconds patience);

// The error of a call that was broken off so others can be received.
absl::Status BrokenOffError();

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_INTAKE_H_
