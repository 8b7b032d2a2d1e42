// One RPC under CallOptions.

#ifndef GEODESIC_CLIENT_CALL_H_
#define GEODESIC_CLIENT_CALL_H_

#include <grpcpp/client_context.h>

#include <algorithm>
#include <chrono>
#include <stop_token>

#include "geodesic_client/client.h"

namespace geodesic::client {

// Holds the context of an RPC for as long as it runs.
class Call {
 public:
  explicit Call(const CallOptions& options)
      : on_stop_(options.stop, Cancel{&context_}) {
    if (options.timeout.has_value()) {
      // A timeout beyond a year is as good as none, and does not overflow.
      constexpr std::chrono::duration<double> kYear(365.0 * 24 * 3600);
      context_.set_deadline(
          std::chrono::system_clock::now() +
          std::chrono::duration_cast<std::chrono::system_clock::duration>(
              std::min(*options.timeout, kYear)));
    }
  }

  grpc::ClientContext* context() { return &context_; }

 private:
  struct Cancel {
    grpc::ClientContext* context;
    // Safe before, during and after the RPC.
    void operator()() const { context->TryCancel(); }
  };

  grpc::ClientContext context_;
  std::stop_callback<Cancel> on_stop_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CALL_H_
