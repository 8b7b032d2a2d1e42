// geodesic.v1.CapabilitiesService.

#ifndef GEODESIC_SERVER_RPC_CAPABILITIES_SERVICE_H_
#define GEODESIC_SERVER_RPC_CAPABILITIES_SERVICE_H_

#include <cstdint>
#include <string>

#include "geodesic/v1/capabilities_service.grpc.pb.h"
#include "server/engine/limits.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

class CapabilitiesService final
    : public v1::CapabilitiesService::CallbackService {
 public:
  // REQUIRES: `log` outlives the service.
  CapabilitiesService(const Limits& limits, uint64_t max_message_bytes,
                      std::string version, RequestLog& log);

  grpc::ServerUnaryReactor* GetCapabilities(
      grpc::CallbackServerContext* context,
      const v1::GetCapabilitiesRequest* request,
      v1::GetCapabilitiesResponse* response) override;

 private:
  v1::GetCapabilitiesResponse capabilities_;
  RequestLog& log_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CAPABILITIES_SERVICE_H_
