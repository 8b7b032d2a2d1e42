// What the calls of a server work with.

#ifndef GEODESIC_SERVER_RPC_CALLS_SERVICE_CONTEXT_H_
#define GEODESIC_SERVER_RPC_CALLS_SERVICE_CONTEXT_H_

#include <string>

#include "geodesic/v1/capabilities_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/intake.h"
#include "server/rpc/calls/request_log.h"

namespace geodesic::server {

// Outlives all calls.
struct ServiceContext {
  QueryEngine& engine;
  RequestLog& log;
  Intake& intake;
  std::string version;  // of the program
  v1::GetCapabilitiesResponse capabilities;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_SERVICE_CONTEXT_H_
