// What a server says of itself: GetCapabilities.

#ifndef GEODESIC_SERVER_RPC_CAPABILITIES_H_
#define GEODESIC_SERVER_RPC_CAPABILITIES_H_

#include <cstdint>
#include <string>

#include "absl/status/status.h"
#include "geodesic/v1/capabilities_service.pb.h"
#include "server/engine/base/limits.h"
#include "server/rpc/calls/unary_call.h"

namespace geodesic::server {

v1::GetCapabilitiesResponse MakeCapabilities(const Limits& limits,
                                             uint64_t max_message_bytes,
                                             const std::string& version);

class CapabilitiesCall final : public UnaryCall<v1::GetCapabilitiesRequest,
                                                v1::GetCapabilitiesResponse> {
 public:
  using UnaryCall::UnaryCall;

 private:
  absl::Status Ask() override {
    Answer(capabilities());
    return absl::OkStatus();
  }
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CAPABILITIES_H_
