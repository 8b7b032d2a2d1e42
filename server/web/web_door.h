// The door for browsers: the page, and the RPCs over gRPC-Web, on one port.
//
//   WebDoor door(options, grpc_server.InProcessChannel({}), peers, intake);
//   absl::Status status = door.Start();
//
// There is no code per method: frames go through an in-process channel, so a
// call has the same tokens, limits and log as any client's.

#ifndef GEODESIC_SERVER_WEB_WEB_DOOR_H_
#define GEODESIC_SERVER_WEB_WEB_DOOR_H_

#include <grpcpp/channel.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "server/rpc/calls/intake.h"
#include "server/rpc/calls/peer.h"
#include "server/web/call_queue.h"
#include "server/web/connection_watch.h"
#include "server/web/origin_policy.h"
#include "server/web/web_call.h"

struct MHD_Daemon;

namespace geodesic::server {

struct WebDoorOptions {
  // HOST:PORT; port 0 takes a free one.
  std::string listen;
  // Other origins whose pages may call (CORS); see IsOrigin.
  std::vector<std::string> origins;
  // PEM texts; empty: in clear.
  std::string certificate;
  std::string key;
  // Largest message and largest body of a request.
  uint64_t max_message_bytes = uint64_t{8} << 20;
  uint64_t max_body_bytes = uint64_t{1} << 30;
  // Connections at once; each may take 64 KiB beside its call.
  unsigned max_connections = 1000;
  // How long the head of a request and each message of its body may take to
  // come in, and how long no byte of an answer may be taken.
  std::chrono::seconds patience{60};
};

// Serves from threads of its own while it lives.
class WebDoor {
 public:
  // REQUIRES: `peers` and `intake` are those of the server behind `channel`,
  // and outlive the door.
  WebDoor(WebDoorOptions options, std::shared_ptr<grpc::Channel> channel,
          const Peers& peers, Intake& intake);
  // Cuts off what is under way.
  ~WebDoor();

  // Call once. Errors: UNAVAILABLE naming the address that could not be bound.
  absl::Status Start();

  // REQUIRES: Start succeeded.
  int port() const;

 private:
  class Exchange;
  struct Stop {
    void operator()(MHD_Daemon* daemon) const;
  };

  const WebDoorOptions options_;
  const OriginPolicy policy_;
  const Peers& peers_;
  CallQueue queue_;
  const WebCall::Context calls_;
  ConnectionWatch watch_;
  // Last, so that it stops before what its thread uses.
  std::unique_ptr<MHD_Daemon, Stop> daemon_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_WEB_WEB_DOOR_H_
