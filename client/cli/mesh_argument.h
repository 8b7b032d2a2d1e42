// The MESH of a command line: a file or a digest.

#ifndef GEODESIC_CLIENT_CLI_MESH_ARGUMENT_H_
#define GEODESIC_CLIENT_CLI_MESH_ARGUMENT_H_

#include <string>

#include "absl/status/statusor.h"
#include "client/cli/session.h"

namespace geodesic::client {

// Uploads the file that MESH names, with progress, unless it is resident.
// Errors: those of Client::UploadFile; local ones are marked by FileError.
absl::StatusOr<UploadOutcome> UploadMeshArgument(const Session& session);

// The digest that MESH stands for. A file is uploaded if the server lacks it;
// the beginning of a digest is completed from the list of resident meshes.
// Errors: the same; FileError if MESH is neither; NOT_FOUND or
// INVALID_ARGUMENT if no mesh, or more than one, has that beginning.
absl::StatusOr<std::string> ResolveMesh(const Session& session);

// The same without uploading. Errors: NOT_FOUND if the file is not known.
absl::StatusOr<std::string> FindMesh(const Session& session);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_MESH_ARGUMENT_H_
