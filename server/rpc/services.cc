#include "server/rpc/services.h"

#include "server/rpc/streams/field.h"
#include "server/rpc/streams/isolines.h"
#include "server/rpc/streams/log_map.h"
#include "server/rpc/streams/matrix.h"
#include "server/rpc/streams/mesh_streams.h"
#include "server/rpc/streams/pairs.h"
#include "server/rpc/streams/paths.h"
#include "server/rpc/streams/samples.h"
#include "server/rpc/streams/trace.h"
#include "server/rpc/unary_calls.h"

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
  services.push_back(
      Make<FieldStream, PathStream, PairStream, MatrixStream, NearestStream,
           IsolineStream, SampleStream, LogMapStream, TraceStream>(
          "geodesic.v1.QuestionService", context));
  services.push_back(
      Make<CapabilitiesCall>("geodesic.v1.CapabilitiesService", context));
  return services;
}

}  // namespace geodesic::server
