// Whether a port that listens is still served.

#ifndef GEODESIC_SERVER_OPERATIONS_ACCEPT_QUEUE_H_
#define GEODESIC_SERVER_OPERATIONS_ACCEPT_QUEUE_H_

#include <chrono>
#include <cstdint>
#include <optional>

namespace geodesic::server {

// How many connections to this port of the machine wait for their server to
// accept them; nothing where the system does not say, or nobody listens there.
// Reads a file of the kernel's. Thread-safe.
std::optional<uint64_t> WaitingConnections(int port);

// Finds out that nobody accepts connections any more, as gRPC does after it
// found no descriptor for one. For one thread.
class AcceptWatch {
 public:
  using Clock = std::chrono::steady_clock;

  // A server that is merely busy accepts sooner.
  static constexpr std::chrono::seconds kPatience{10};

  // `waiting` connections at this time. Whether the port is served: false once
  // some have waited, whenever it was called, for kPatience.
  bool IsServed(uint64_t waiting, Clock::time_point now);

 private:
  std::optional<Clock::time_point> waiting_since_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_OPERATIONS_ACCEPT_QUEUE_H_
