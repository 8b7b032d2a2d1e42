// The commands of `geodesic`.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_H_

#include "absl/status/status.h"
#include "client/cli/session.h"

namespace geodesic::client {

// Runs the command of the session's arguments and prints its result: a table,
// or one JSON object. Nothing has been printed to `out` if it fails, but for
// what is printed as it comes: progressive fields, and matrices without a file.
absl::Status RunCommand(const Session& session);

// One each; RunCommand chooses.
absl::Status RunUpload(const Session& session);
absl::Status RunMeshes(const Session& session);
absl::Status RunInfo(const Session& session);
absl::Status RunDelete(const Session& session);
absl::Status RunField(const Session& session);
absl::Status RunPath(const Session& session);
absl::Status RunIsolines(const Session& session);
absl::Status RunMatrix(const Session& session);
absl::Status RunNearest(const Session& session);
absl::Status RunSample(const Session& session);
absl::Status RunLogMap(const Session& session);
absl::Status RunCapabilities(const Session& session);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_H_
