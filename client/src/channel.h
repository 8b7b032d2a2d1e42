// The channel of a Client: credentials, limits, retries.

#ifndef GEODESIC_CLIENT_CHANNEL_H_
#define GEODESIC_CLIENT_CHANNEL_H_

#include <grpcpp/channel.h>

#include <memory>
#include <string>

#include "geodesic_client/connection_options.h"

namespace geodesic::client {

// Connects at the first call.
std::shared_ptr<grpc::Channel> MakeChannel(const std::string& server,
                                           const ConnectionOptions& options);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CHANNEL_H_
