#include "server/rpc/calls/required_scope.h"

#include <utility>

namespace geodesic::server {
namespace {

constexpr std::pair<std::string_view, Scope> kRequired[] = {
    {"FindMissingMeshes", Scope::kRead},
    {"GetMesh", Scope::kRead},
    {"ReadMesh", Scope::kRead},
    {"ListMeshes", Scope::kRead},
    {"CreateMesh", Scope::kUpload},
    {"DeleteMesh", Scope::kDelete},
    {"ComputeField", Scope::kRead},
    {"ComputeLogMap", Scope::kRead},
    {"SampleFarthestPoints", Scope::kRead},
    {"ComputePaths", Scope::kRead},
    {"ComputeIsolines", Scope::kRead},
    {"ComputeMatrix", Scope::kRead},
    {"ComputePairs", Scope::kRead},
    {"FindNearest", Scope::kRead},
    {"TraceLines", Scope::kRead},
    {"GetCapabilities", Scope::kRead},
};

}  // namespace

Scope RequiredScope(std::string_view method) {
  for (const auto& [name, scope] : kRequired) {
    if (name == method) return scope;
  }
  return Scope::kAdmin;
}

}  // namespace geodesic::server
