// delete: drops a mesh from the server.

#include "client/cli/commands/command.h"
#include "client/cli/commands/json.h"
#include "client/cli/commands/mesh_argument.h"

namespace geodesic::client {
namespace {

void AddOptions(CLI::App* app, MeshArgument* mesh) {
  AddMesh(app,
          "The digest of a resident mesh, of which the first 8 digits do if "
          "they are unique; or the file it came from",
          mesh);
}

absl::Status Run(const MeshArgument& mesh, const Session& session) {
  absl::StatusOr<std::string> digest = FindMesh(session, mesh);
  if (!digest.ok()) return digest.status();
  absl::Status status = session.client.DeleteMesh(*digest, session.call);
  if (!status.ok()) return status;
  if (session.json) {
    PrintJson({{"deleted", *digest}}, &session.out);
  } else if (!session.quiet) {
    session.out << "deleted " << *digest << '\n';
  }
  return absl::OkStatus();
}

}  // namespace

Command DeleteCommand() {
  return MakeCommand("delete", "Drop a mesh from the server",
                     "  geodesic delete horse.ply", AddOptions, Run);
}

}  // namespace geodesic::client
