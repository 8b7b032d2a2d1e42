// All services of the protocol.

#ifndef GEODESIC_SERVER_RPC_SERVICES_H_
#define GEODESIC_SERVER_RPC_SERVICES_H_

#include <memory>
#include <vector>

#include "server/rpc/calls/service.h"

namespace geodesic::server {

// REQUIRES: `context` outlives them.
std::vector<std::unique_ptr<Service>> MakeServices(
    const ServiceContext& context);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_SERVICES_H_
