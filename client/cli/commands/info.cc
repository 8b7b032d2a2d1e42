// info: describes a mesh.

#include "client/cli/commands/command.h"
#include "client/cli/commands/json.h"
#include "client/cli/commands/mesh_argument.h"
#include "client/cli/commands/mesh_facts.h"

namespace geodesic::client {
namespace {

void AddOptions(CLI::App* app, MeshArgument* mesh) {
  AddMesh(app, kMeshHelp, mesh);
}

absl::Status Run(const MeshArgument& argument, const Session& session) {
  return AskAboutMesh(session, argument, [&](const std::string& digest) {
    absl::StatusOr<MeshInfo> mesh =
        session.client.GetMesh(digest, session.call);
    if (!mesh.ok()) return mesh.status();
    if (session.json) {
      PrintJson(ToJson(*mesh), &session.out);
    } else {
      PrintFacts(FactsOf(*mesh), &session.out);
    }
    return absl::OkStatus();
  });
}

}  // namespace

Command InfoCommand() {
  return MakeCommand("info", "Describe a mesh: counts, topology, size",
                     "  geodesic info horse.ply", AddOptions, Run);
}

}  // namespace geodesic::client
