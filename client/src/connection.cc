#include "connection.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/support/channel_arguments.h>
#include <grpcpp/support/client_interceptor.h>

#include <random>
#include <utility>
#include <vector>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "service_config.h"

namespace geodesic::client {
namespace {

using grpc::experimental::ClientInterceptorFactoryInterface;

// 128 random bits, which need to be unique only.
std::string MakeRequestId() {
  thread_local std::mt19937_64 random{std::random_device{}()};
  const uint64_t high = random();
  const uint64_t low = random();
  return absl::StrCat(absl::Hex(high, absl::kZeroPad16),
                      absl::Hex(low, absl::kZeroPad16));
}

// Adds "x-request-id" to every call, by which the server's log can be searched,
// and "authorization" unless it is empty. gRPC's own call credentials cannot
// serve, since they refuse calls without TLS.
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

// Belongs to the channel and so outlives its calls.
class CallMetadataFactory final : public ClientInterceptorFactoryInterface {
 public:
  explicit CallMetadataFactory(const std::string& token)
      : authorization_(
            token.empty()
                ? ""
                : absl::StrCat("Bearer ",
                               IsToken(token) ? token : absl::CEscape(token))) {
  }

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
  // A page of meshes or a chunk of a field is far smaller. The server has its
  // own limit on requests.
  arguments.SetMaxReceiveMessageSize(64 * kMebibyte);
  arguments.SetMaxSendMessageSize(64 * kMebibyte);
  // Pings notice a dead peer while a call waits. By default, servers hang up on
  // clients that ping more often than every five minutes.
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIME_MS, 5 * 60 * 1000 + 10 * 1000);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 20 * 1000);
  // Time for one attempt to connect. gRPC's 20 s is long for a waiting user.
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, 5 * 1000);
  // Clients of one process do not share a connection to the same server, so
  // destroying a client closes its connection.
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  // Look-ups change nothing, so gRPC repeats them until an answer begins: if
  // the server is not there, or if it is full, after the time that it suggests.
  // Questions are repeated by Ask, also once an answer has begun. DeleteMesh is
  // not repeated: if the answer to a call that deleted the mesh were lost, the
  // repetition would report it missing. CreateMesh sends too much for gRPC to
  // keep, so upload.cc repeats it.
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
      questions(v1::QuestionService::NewStub(channel)) {}

}  // namespace geodesic::client
