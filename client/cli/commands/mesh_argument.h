// Finds or uploads the MESH of a command line, which is a file or a digest.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_MESH_ARGUMENT_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_MESH_ARGUMENT_H_

#include <functional>
#include <string>

#include "absl/status/statusor.h"
#include "client/cli/arguments/options.h"
#include "client/cli/commands/command.h"

namespace geodesic::client {

// Uploads the file that `mesh` names, with progress, unless it is resident.
// Errors: those of Client::UploadFile. FileError marks those of this machine.
absl::StatusOr<UploadOutcome> UploadMesh(const Session& session,
                                         const MeshArgument& mesh);

// Calls `ask` with the digest that `mesh` stands for. A file is uploaded if the
// server lacks it, and once more if the server evicts it before `ask` reaches
// it. The beginning of a digest is completed from the list of resident meshes.
// Errors: those of `ask` and UploadMesh; FileError if `mesh` is neither a file
// nor a digest; NOT_FOUND if no mesh has that beginning, INVALID_ARGUMENT if
// more than one has.
absl::Status AskAboutMesh(
    const Session& session, const MeshArgument& mesh,
    const std::function<absl::Status(const std::string& digest)>& ask);

// The digest, without uploading.
// Errors: NOT_FOUND if the server does not know the file.
absl::StatusOr<std::string> FindMesh(const Session& session,
                                     const MeshArgument& mesh);

// Whether `mesh` is the name of a .ply file (.ply.gz), there or not.
bool IsPlyFile(const MeshArgument& mesh);

// Whether it is there and holds the mesh of this digest, as far as the server
// knows.
bool IsPlyFileOf(const Session& session, const MeshArgument& mesh,
                 const std::string& digest);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_MESH_ARGUMENT_H_
