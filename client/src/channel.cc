#include "channel.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/support/channel_arguments.h>

#include <utility>
#include <vector>

#include "call_metadata.h"
#include "service_config.h"

namespace geodesic::client {
namespace {

constexpr int kMebibyte = 1 << 20;

std::shared_ptr<grpc::ChannelCredentials> MakeCredentials(
    const std::optional<TlsOptions>& tls) {
  if (!tls.has_value()) return grpc::InsecureChannelCredentials();
  grpc::SslCredentialsOptions options;
  options.pem_root_certs = tls->authorities;
  options.pem_cert_chain = tls->certificate;
  options.pem_private_key = tls->key;
  return grpc::SslCredentials(options);
}

}  // namespace

std::shared_ptr<grpc::Channel> MakeChannel(const std::string& server,
                                           const ConnectionOptions& options) {
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
  if (options.retry) {
    arguments.SetServiceConfigJSON(kServiceConfig);
  } else {
    arguments.SetInt(GRPC_ARG_ENABLE_RETRIES, 0);
  }
  if (options.tls.has_value() && !options.tls->server_name.empty()) {
    arguments.SetSslTargetNameOverride(options.tls->server_name);
  }
  std::vector<
      std::unique_ptr<grpc::experimental::ClientInterceptorFactoryInterface>>
      interceptors;
  interceptors.push_back(MakeCallMetadata(options.token));
  return grpc::experimental::CreateCustomChannelWithInterceptors(
      server, MakeCredentials(options.tls), arguments, std::move(interceptors));
}

}  // namespace geodesic::client
