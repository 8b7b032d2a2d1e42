#include "connection.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/support/channel_arguments.h>
#include <grpcpp/support/client_interceptor.h>

#include <random>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "service_config.h"

namespace geodesic::client {
namespace {

using grpc::experimental::ClientInterceptorFactoryInterface;

// 128 random bits; uniqueness is all that is asked of them.
std::string MakeRequestId() {
  thread_local std::mt19937_64 random{std::random_device{}()};
  const uint64_t high = random();
  const uint64_t low = random();
  return absl::StrCat(absl::Hex(high, absl::kZeroPad16),
                      absl::Hex(low, absl::kZeroPad16));
}

// Adds what every call says of itself: "x-request-id", by which the server's
// log can be searched, and "authorization" unless it is empty. Calls without
// TLS get that too, which gRPC's own call credentials refuse.
class CallMetadata final : public grpc::experimental::Interceptor {
 public:
  explicit CallMetadata(const std::string& authorization)
      : authorization_(authorization) {}

  void Intercept(
      grpc::experimental::InterceptorBatchMethods* methods) override {
    if (methods->QueryInterceptionHookPoint(
            grpc::experimental::InterceptionHookPoints::
                PRE_SEND_INITIAL_METADATA)) {
      auto* metadata = methods->GetSendInitialMetadata();
      metadata->emplace("x-request-id", MakeRequestId());
      if (!authorization_.empty()) {
        metadata->emplace("authorization", authorization_);
      }
    }
    methods->Proceed();
  }

 private:
  const std::string& authorization_;
};

// Belongs to the channel, which outlives its calls.
class CallMetadataFactory final : public ClientInterceptorFactoryInterface {
 public:
  explicit CallMetadataFactory(const std::string& token)
      : authorization_(token.empty() ? "" : absl::StrCat("Bearer ", token)) {}

  grpc::experimental::Interceptor* CreateClientInterceptor(
      grpc::experimental::ClientRpcInfo*) override {
    return new CallMetadata(authorization_);
  }

 private:
  const std::string authorization_;
};

std::shared_ptr<grpc::ChannelCredentials> MakeCredentials(
    const std::optional<TlsOptions>& tls) {
  if (!tls.has_value()) return grpc::InsecureChannelCredentials();
  grpc::SslCredentialsOptions options;
  options.pem_root_certs = tls->authorities;
  options.pem_cert_chain = tls->certificate;
  options.pem_private_key = tls->key;
  return grpc::SslCredentials(options);
}

// Connects at the first call.
std::shared_ptr<grpc::Channel> MakeChannel(const std::string& server,
                                           const ConnectionOptions& options) {
  constexpr int kMebibyte = 1 << 20;
  grpc::ChannelArguments arguments;
  // A page of meshes or a chunk of a field is far smaller; the server's own
  // limit on requests is its own affair.
  arguments.SetMaxReceiveMessageSize(64 * kMebibyte);
  arguments.SetMaxSendMessageSize(64 * kMebibyte);
  // A dead peer is noticed while a call waits. Servers by default hang up on
  // clients that ping more often than every five minutes.
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIME_MS, 5 * 60 * 1000 + 10 * 1000);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 20 * 1000);
  // Time for one attempt to connect; gRPC's 20 s is long for someone waiting.
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, 5 * 1000);
  // Clients of one process that name the same server do not share a
  // connection, so that closing one means closing it.
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  // Questions and look-ups change nothing, so gRPC asks them again while
  // nothing of an answer has come: when the server is not there, or, at the
  // time it names itself, when it is full. A mesh that was deleted by a call
  // whose answer was lost would then be reported missing, so DeleteMesh is not
  // among them; and what CreateMesh sends is too much to be kept for a
  // repetition by gRPC, so upload.cc sees to that.
  if (options.retry) {
    arguments.SetServiceConfigJSON(kServiceConfig);
  } else {
    arguments.SetInt(GRPC_ARG_ENABLE_RETRIES, 0);
  }
  if (options.tls.has_value() && !options.tls->server_name.empty()) {
    arguments.SetSslTargetNameOverride(options.tls->server_name);
  }
  std::vector<std::unique_ptr<ClientInterceptorFactoryInterface>> interceptors;
  interceptors.push_back(std::make_unique<CallMetadataFactory>(options.token));
  return grpc::experimental::CreateCustomChannelWithInterceptors(
      server, MakeCredentials(options.tls), arguments, std::move(interceptors));
}

}  // namespace

Client::Connection::Connection(const std::string& server,
                               const ConnectionOptions& options)
    : retry(options.retry),
      channel(MakeChannel(server, options)),
      meshes(v1::MeshService::NewStub(channel)),
      capabilities(v1::CapabilitiesService::NewStub(channel)),
      fields(v1::FieldService::NewStub(channel)),
      paths(v1::PathService::NewStub(channel)),
      matrices(v1::MatrixService::NewStub(channel)) {}

}  // namespace geodesic::client
