// Who a call comes from.
//
// The calls of browsers come from server/web by a channel within the process,
// where gRPC knows no address. The door says it in metadata, with a secret of
// this process, so that nobody else can.

#ifndef GEODESIC_SERVER_RPC_CALLS_PEER_H_
#define GEODESIC_SERVER_RPC_CALLS_PEER_H_

#include <grpcpp/client_context.h>
#include <grpcpp/server_context.h>

#include <string>
#include <string_view>

namespace geodesic::server {

struct Peer {
  // As gRPC writes one: "ipv4:10.1.2.3:53412".
  std::string address;
  // Whether the call is a browser's.
  bool by_door = false;
};

// An address without the port, which differs between connections:
// "ipv4:10.1.2.3" for "ipv4:10.1.2.3:53412".
std::string PeerHost(std::string_view address);

// Immutable, so thread-safe.
class Peers {
 public:
  // Draws the secret.
  Peers();

  // Says in the metadata of a call of the door whose it is.
  void Name(const std::string& address, grpc::ClientContext& context) const;

  // Whose a call is.
  Peer Of(const grpc::CallbackServerContext& context) const;

 private:
  const std::string secret_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_PEER_H_
