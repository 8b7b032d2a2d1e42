// The channel of a Client, the stubs on it, and one RPC under CallOptions.

#ifndef GEODESIC_CLIENT_CONNECTION_H_
#define GEODESIC_CLIENT_CONNECTION_H_

#include <grpcpp/channel.h>
#include <grpcpp/client_context.h>
#include <grpcpp/support/sync_stream.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>

#include "codec/answer_reader.h"
#include "geodesic/v1/capabilities_service.grpc.pb.h"
#include "geodesic/v1/mesh_service.grpc.pb.h"
#include "geodesic/v1/question_service.grpc.pb.h"
#include "geodesic_client/client.h"
#include "rpc_status.h"

namespace geodesic::client {

// A method of the service.
using Questions = v1::QuestionService::Stub;
template <typename Request>
using Question = std::unique_ptr<grpc::ClientReader<v1::Answer>> (Questions::*)(
    grpc::ClientContext*, const Request&);

// Takes an answer's progress and the number of vertices.
using TakeProgress = std::function<void(const v1::SolveProgress&, uint64_t)>;

struct Client::Connection {
  Connection(const std::string& server, const ConnectionOptions& options);

  // Asks a question and reads the answer to its end; `info`, an AnswerInfo or a
  // Field, receives what it says about itself. Asks again where that may help,
  // for the rest of an answer that has begun, as often as WaitToRetry allows
  // without anything new. `take`, which may be empty, is called after each
  // message and hands out what `reader` has collected. That cannot be taken
  // back, so such an answer is never begun anew.
  // Errors: that of `request`; the server's; that of `take`, which ends the
  // call; DATA_LOSS if the answer breaks the protocol.
  template <typename Request, typename Info>
  absl::Status Ask(Question<Request> question, absl::StatusOr<Request> request,
                   const CallOptions& options, const TakeProgress& progress,
                   codec::AnswerReader* reader, Info* info,
                   const std::function<absl::Status()>& take = nullptr) const;

  const bool retry;  // see ConnectionOptions
  std::shared_ptr<grpc::Channel> channel;
  std::unique_ptr<v1::MeshService::Stub> meshes;
  std::unique_ptr<v1::CapabilitiesService::Stub> capabilities;
  std::unique_ptr<Questions> questions;
};

// The context of one RPC, which it must outlive.
class Call {
 public:
  // `mesh`: the digest that the RPC is about, by which a balancer finds the
  // replica that has the mesh (protocol.md, "Several servers"): of a mesh, or
  // of a file whose mesh is not known. Empty for none.
  Call(const CallOptions& options, const std::string& mesh)
      : on_stop_(options.stop, Cancel{&context_}) {
    if (!mesh.empty()) context_.AddMetadata("geo-mesh-digest", mesh);
    if (options.timeout.has_value()) {
      // A year is as good as no timeout, and does not overflow.
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

// Gives `consume` each message of a stream until the stream ends or `consume`
// returns an error, which ends the call.
// Errors: that of `consume`, or the server's.
template <typename Response, typename Consume>
absl::Status ReadStream(Call* call,
                        std::unique_ptr<grpc::ClientReader<Response>> reader,
                        Consume consume) {
  Response response;
  absl::Status consumed;
  while (consumed.ok() && reader->Read(&response)) consumed = consume(response);
  if (!consumed.ok()) call->context()->TryCancel();
  const absl::Status status = FromRpcStatus(reader->Finish());
  return consumed.ok() ? status : consumed;
}

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CONNECTION_H_
