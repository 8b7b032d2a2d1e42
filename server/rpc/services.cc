#include "server/rpc/services.h"

#include "server/rpc/capabilities.h"
#include "server/rpc/mesh_calls.h"
#include "server/rpc/streams/field_stream.h"
#include "server/rpc/streams/isoline_stream.h"
#include "server/rpc/streams/log_map_stream.h"
#include "server/rpc/streams/matrix_stream.h"
#include "server/rpc/streams/mesh_stream.h"
#include "server/rpc/streams/nearest_stream.h"
#include "server/rpc/streams/path_stream.h"
#include "server/rpc/streams/sample_stream.h"
#include "server/rpc/streams/upload_stream.h"

namespace geodesic::server {
namespace {

template <typename... Calls>
std::unique_ptr<Service> Make(const char* name, const ServiceContext& context) {
  auto service = std::make_unique<Service>(name);
  (service->Add<Calls>(context), ...);
  return service;
}

}  // namespace

std::vector<std::unique_ptr<Service>> MakeServices(
    const ServiceContext& context) {
  std::vector<std::unique_ptr<Service>> services;
  services.push_back(
      Make<FindMissingCall, UploadStream, GetMeshCall, MeshStream,
           ListMeshesCall, DeleteMeshCall>("geodesic.v1.MeshService", context));
  services.push_back(Make<FieldStream, LogMapStream, SampleStream>(
      "geodesic.v1.FieldService", context));
  services.push_back(
      Make<PathStream, IsolineStream>("geodesic.v1.PathService", context));
  services.push_back(
      Make<MatrixStream, NearestStream>("geodesic.v1.MatrixService", context));
  services.push_back(
      Make<CapabilitiesCall>("geodesic.v1.CapabilitiesService", context));
  return services;
}

}  // namespace geodesic::server
