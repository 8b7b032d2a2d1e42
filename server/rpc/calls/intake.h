// How requests come in: how many messages at once, how long each may take, and
// what requests may hold.
//
// While a message is received gRPC may set aside as much memory as the largest
// message takes, so each takes a slot. Who finds none waits, held back by flow
// control after 64 KiB. So that nobody keeps the others out by sending slowly,
// or not at all, connections share the slots evenly: when one waits that has
// fewer than another, the other's oldest reception is broken off, unless it is
// young.

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
#include <mutex>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/engine/base/byte_budget.h"

namespace geodesic::server {

// Who receives a message. Both are called without a lock of the intake's.
class Receiver {
 public:
  virtual ~Receiver() = default;

  // There is a slot: read, then leave it.
  virtual void OnSlot() = 0;

  // Others wait: end. Called again, from time to time, until the slot is left.
  virtual void OnBrokenOff() = 0;
};

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

  // Gives `receiver` a slot, at once or later. `connection` tells connections
  // apart. REQUIRES: the caller holds no lock that OnSlot takes.
  void Enter(std::shared_ptr<Receiver> receiver, const std::string& connection);

  // REQUIRES: it has a slot; the caller holds no lock that another's OnSlot
  // takes.
  void Leave(const Receiver& receiver);

  // Decodes a request, and reserves memory for it and for the question that is
  // made from it before it does.
  // Errors: INVALID_ARGUMENT: malformed; RESOURCE_EXHAUSTED naming the request
  // memory, with a retry hint when an idle server would have it.
  absl::StatusOr<ByteReservation> Decode(
      grpc::ByteBuffer& bytes, google::protobuf::Message& request) const;

  // Lets go of what was reserved for the request, which is gone, and keeps what
  // the question takes. Call once.
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

  // Gives free slots to those who wait, without the lock.
  void Serve();
  // Breaks receptions off for those who wait, and comes again if some still do.
  void MakeRoom();
  // The rest REQUIRES: mutex_ held.
  // The connection that waits and has the fewest slots; none: null.
  std::pair<const std::string, Connection>* Neediest();
  void Watch();

  const std::shared_ptr<ByteBudget> memory_;
  const std::chrono::milliseconds patience_;

  std::mutex mutex_;
  // Guarded by mutex_:
  uint64_t free_slots_;
  std::map<std::string, Connection> connections_;
  std::list<Reception> held_;  // oldest first
  std::optional<grpc::Alarm> alarm_;
  bool is_watching_ = false;
};

// How much memory a message takes once it is decoded, told before it is:
// an upper bound on what a message of this type takes when it is parsed from
// these bytes: two bytes can become 70. Nothing is allocated for what the
// bytes say. Of malformed bytes the part before the fault counts, which is what
// a parser may have set aside. O(bytes).
uint64_t DecodedSize(const google::protobuf::Descriptor& type,
                     google::protobuf::io::ZeroCopyInputStream& bytes);

// The error of a message that was late.
absl::Status LateError(std::chrono::milliseconds patience);

// The error of one that was broken off, so that others can be received.
absl::Status BrokenOffError();

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_INTAKE_H_
