// A call's deadline on the engine's clock.

#ifndef GEODESIC_SERVER_RPC_CALLS_CALL_DEADLINE_H_
#define GEODESIC_SERVER_RPC_CALLS_CALL_DEADLINE_H_

#include <grpcpp/server_context.h>

#include <chrono>

#include "server/engine/base/clock.h"

namespace geodesic::server {

// gRPC tells deadlines in the system's time.
inline TimePoint CallDeadline(const grpc::CallbackServerContext& context) {
  const auto deadline = context.deadline();
  const auto now = std::chrono::system_clock::now();
  // Anything further away than this is as good as none.
  if (deadline > now + std::chrono::hours(24 * 365)) return kNoDeadline;
  return std::chrono::steady_clock::now() + (deadline - now);
}

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_CALL_DEADLINE_H_
