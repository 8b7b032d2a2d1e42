// What every unary RPC shares.

#ifndef GEODESIC_SERVER_RPC_UNARY_CALL_H_
#define GEODESIC_SERVER_RPC_UNARY_CALL_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <string>
#include <utility>

#include "absl/status/status.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

// Answers a unary RPC with `work`, which takes a RequestLog::Entry& and returns
// an absl::Status; it must be short.
template <typename Work>
grpc::ServerUnaryReactor* AnswerUnary(grpc::CallbackServerContext* context,
                                      RequestLog& log, std::string_view method,
                                      Work work) {
  RequestLog::Entry entry(log, method, *context);
  absl::Status status = entry.Admit();
  if (status.ok()) status = work(entry);
  grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
  reactor->Finish(entry.End(std::move(status)));
  return reactor;
}

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_UNARY_CALL_H_
