// The channel of a Client and the stubs on it.

#ifndef GEODESIC_CLIENT_CONNECTION_H_
#define GEODESIC_CLIENT_CONNECTION_H_

#include <grpcpp/channel.h>

#include <memory>
#include <string>

#include "geodesic/v1/capabilities_service.grpc.pb.h"
#include "geodesic/v1/field_service.grpc.pb.h"
#include "geodesic/v1/matrix_service.grpc.pb.h"
#include "geodesic/v1/mesh_service.grpc.pb.h"
#include "geodesic/v1/path_service.grpc.pb.h"
#include "geodesic_client/client.h"

namespace geodesic::client {

struct Client::Connection {
  Connection(const std::string& server, const ConnectionOptions& options);

  const bool retry;  // see ConnectionOptions
  std::shared_ptr<grpc::Channel> channel;
  std::unique_ptr<v1::MeshService::Stub> meshes;
  std::unique_ptr<v1::CapabilitiesService::Stub> capabilities;
  std::unique_ptr<v1::FieldService::Stub> fields;
  std::unique_ptr<v1::PathService::Stub> paths;
  std::unique_ptr<v1::MatrixService::Stub> matrices;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CONNECTION_H_
