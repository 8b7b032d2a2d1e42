// The service configuration, which other clients are given too, names what
// there is.

#include <google/protobuf/descriptor.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "geodesic/v1/capabilities_service.pb.h"
#include "geodesic/v1/field_service.pb.h"
#include "geodesic/v1/matrix_service.pb.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "geodesic/v1/path_service.pb.h"

namespace geodesic::client {
namespace {

using Json = nlohmann::json;

TEST(ServiceConfig, NamesServicesAndMethodsThatExist) {
  std::ifstream file(GEODESIC_SERVICE_CONFIG);
  ASSERT_TRUE(file) << GEODESIC_SERVICE_CONFIG;
  const Json config = Json::parse(file);
  std::map<std::string, const google::protobuf::ServiceDescriptor*> services;
  for (const auto* message : {v1::GetCapabilitiesRequest::descriptor(),
                              v1::ComputeFieldRequest::descriptor(),
                              v1::ComputeMatrixRequest::descriptor(),
                              v1::GetMeshRequest::descriptor(),
                              v1::ComputePathsRequest::descriptor()}) {
    const auto* service = message->file()->service(0);
    services[service->full_name()] = service;
  }
  int checked = 0;
  for (const Json& name : config["methodConfig"][0]["name"]) {
    const auto* service = services[name["service"].get<std::string>()];
    ASSERT_NE(service, nullptr) << name;
    if (name.contains("method")) {
      EXPECT_NE(service->FindMethodByName(name["method"].get<std::string>()),
                nullptr)
          << name;
    }
    ++checked;
  }
  EXPECT_EQ(checked, 8);
}

}  // namespace
}  // namespace geodesic::client
