// Bounds the messages that are received at once.
//
// While a message is received gRPC may set aside as much memory as the largest
// message takes, so each takes a slot. Who finds none waits, held back by flow
// control after 64 KiB. So that nobody keeps the others out by sending slowly,
// or not at all, connections share the slots evenly: when one waits that has
// fewer than another, the other's oldest reception is broken off, unless it is
// young.

#ifndef GEODESIC_SERVER_RPC_CALLS_RECEIVE_SLOTS_H_
#define GEODESIC_SERVER_RPC_CALLS_RECEIVE_SLOTS_H_

#include <grpcpp/alarm.h>

#include <chrono>
#include <cstddef>
#include <deque>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace geodesic::server {

// Who receives a message. Both are called without a lock of the slots'.
class Receiver {
 public:
  virtual ~Receiver() = default;

  // There is a slot: read, then leave it.
  virtual void OnSlot() = 0;

  // Others wait: end. Called again, from time to time, until the slot is left.
  virtual void OnBrokenOff() = 0;
};

// Thread-safe.
class ReceiveSlots {
 public:
  explicit ReceiveSlots(size_t count) : free_(count) {}

  // Gives `receiver` a slot, at once or later. `connection` tells connections
  // apart. REQUIRES: the caller holds no lock that OnSlot takes.
  void Enter(std::shared_ptr<Receiver> receiver, const std::string& connection);

  // REQUIRES: it has a slot; the caller holds no lock that another's OnSlot
  // takes.
  void Leave(const Receiver& receiver);

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

  std::mutex mutex_;
  // Guarded by mutex_:
  size_t free_;
  std::map<std::string, Connection> connections_;
  std::list<Reception> held_;  // oldest first
  std::optional<grpc::Alarm> alarm_;
  bool is_watching_ = false;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_RECEIVE_SLOTS_H_
