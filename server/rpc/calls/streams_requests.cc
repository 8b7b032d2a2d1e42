#include "server/rpc/calls/streams_requests.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>

namespace geodesic::server {

bool StreamsRequests(std::string path) {
  path.erase(0, 1);
  std::replace(path.begin(), path.end(), '/', '.');
  const auto* method =
      google::protobuf::DescriptorPool::generated_pool()->FindMethodByName(
          path);
  return method != nullptr && method->client_streaming();
}

}  // namespace geodesic::server
