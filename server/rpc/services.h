// The services of the protocol: which call answers which method.

#ifndef GEODESIC_SERVER_RPC_SERVICES_H_
#define GEODESIC_SERVER_RPC_SERVICES_H_

#include <memory>
#include <vector>

#include "server/rpc/calls/service.h"
#include "server/rpc/calls/service_context.h"

namespace geodesic::server {

// All of them. `context` outlives them.
std::vector<std::unique_ptr<Service>> MakeServices(
    const ServiceContext& context);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_SERVICES_H_
