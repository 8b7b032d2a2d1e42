// meshes: lists what is resident.

#include <string>
#include <vector>

#include "client/cli/commands/command.h"
#include "client/cli/commands/json.h"
#include "client/cli/commands/mesh_facts.h"

namespace geodesic::client {
namespace {

absl::Status Run(const NoArguments&, const Session& session) {
  absl::StatusOr<std::vector<MeshInfo>> meshes =
      session.client.ListMeshes(session.call);
  if (!meshes.ok()) return meshes.status();
  if (session.json) {
    Json list = Json::array();
    for (const MeshInfo& mesh : *meshes) list.push_back(ToJson(mesh));
    PrintJson({{"meshes", list}}, &session.out);
    return absl::OkStatus();
  }
  if (meshes->empty()) {
    session.out << "no resident meshes: add one with geodesic upload FILE\n";
    return absl::OkStatus();
  }
  std::vector<std::vector<std::string>> rows;
  for (const MeshInfo& mesh : *meshes) {
    rows.push_back({mesh.digest.substr(0, 16), GroupedNumber(mesh.vertex_count),
                    GroupedNumber(mesh.face_count),
                    GroupedNumber(mesh.component_count),
                    GroupedNumber(mesh.boundary_loop_count), Genus(mesh),
                    ByteCount(mesh.resident_bytes)});
  }
  PrintTable({"digest", "vertices", "faces", "components", "boundaries",
              "genus", "resident"},
             rows, &session.out);
  return absl::OkStatus();
}

}  // namespace

Command MeshesCommand() {
  return MakeCommand("meshes", "List the resident meshes", "  geodesic meshes",
                     AddNoOptions, Run);
}

}  // namespace geodesic::client
