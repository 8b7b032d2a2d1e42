// The MESH of a command line: a file or a digest.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_MESH_ARGUMENT_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_MESH_ARGUMENT_H_

#include <functional>
#include <string>

#include "absl/status/statusor.h"
#include "client/cli/arguments/options.h"
#include "client/cli/commands/command.h"

namespace geodesic::client {

// Uploads the file that `mesh` names, with progress, unless it is resident.
// Errors: those of Client::UploadFile; local ones are marked by FileError.
absl::StatusOr<UploadOutcome> UploadMesh(const Session& session,
                                         const MeshArgument& mesh);

// Calls `ask` with the digest that `mesh` stands for. A file is uploaded if the
// server lacks it, and once more if it was evicted before it was asked about;
// the beginning of a digest is completed from the list of resident meshes.
// Errors: those of `ask` and UploadMesh; FileError if `mesh` is neither;
// NOT_FOUND or INVALID_ARGUMENT if no mesh, or more than one, has that
// beginning.
absl::Status AskAboutMesh(
    const Session& session, const MeshArgument& mesh,
    const std::function<absl::Status(const std::string& digest)>& ask);

// The digest, without uploading. Errors: NOT_FOUND if the file is not known.
absl::StatusOr<std::string> FindMesh(const Session& session,
                                     const MeshArgument& mesh);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_MESH_ARGUMENT_H_
