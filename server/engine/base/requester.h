// Who asks, and how urgent it is to them.

#ifndef GEODESIC_SERVER_ENGINE_BASE_REQUESTER_H_
#define GEODESIC_SERVER_ENGINE_BASE_REQUESTER_H_

#include <string>

namespace geodesic::server {

struct Requester {
  // Names the client in messages to itself. Clients take turns, and each has a
  // share of the queue. Empty: the server itself, which has no share.
  std::string client;
  // Whether others, who wait for their answers, may go first.
  bool is_batch = false;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_BASE_REQUESTER_H_
